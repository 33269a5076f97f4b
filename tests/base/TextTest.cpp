// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/base/Text.h>

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

using namespace osgTreeWind;

namespace {

std::string problemOf(const std::string& content) {
    std::istringstream input(content);
    return firstProblem(readText(input, "f"));
}

} // namespace

TEST(Text, SkipsTheByteOrderMark) {
    std::istringstream input("\xEF\xBB\xBFhello");
    EXPECT_EQ(readText(input, "f").value(), "hello");
}

TEST(Text, ReadsTextLongerThanItsBuffer) {
    const std::string content(100001, 'x');
    std::istringstream input(content);
    EXPECT_EQ(readText(input, "f").value(), content);
}

TEST(Text, RejectsAnEmptyFile) {
    EXPECT_EQ(problemOf(""), "f: the file is empty");
    EXPECT_EQ(problemOf("\xEF\xBB\xBF"), "f: the file is empty");
}

TEST(Text, ReportsThePositionOfBinaryData) {
    EXPECT_EQ(problemOf(std::string("ab\nc\0d", 6)), "f:2:2: expected text, found binary data");
    EXPECT_EQ(problemOf("\x7f"
                        "ELF"),
              "f:1:1: expected text, found binary data");
}

TEST(Text, RejectsAFolder) {
    std::ifstream folder("/");
    EXPECT_EQ(firstProblem(readText(folder, "/")), "/: cannot be read");
}

TEST(Text, RejectsAMissingFile) {
    std::ifstream missing("/no/such/file");
    EXPECT_EQ(firstProblem(readText(missing, "f")), "f: cannot be read");
}

TEST(Text, PositionCountsEveryKindOfLineEnd) {
    const std::string text = "a\nbc\r\nd\re";
    const auto position = [&](std::size_t offset) {
        const TextPosition p = positionInText(text, offset);
        return std::to_string(p.line) + ":" + std::to_string(p.column);
    };
    EXPECT_EQ(position(0), "1:1");
    EXPECT_EQ(position(text.find('c')), "2:2");
    EXPECT_EQ(position(text.find('d')), "3:1");
    EXPECT_EQ(position(text.find('e')), "4:1");
    EXPECT_EQ(position(1000), "4:2");
}

TEST(Text, RespectsTheMemoryLimit) {
    const EnvironmentVariable limit("OSGTREEWIND_MAX_MEMORY", "100M");
    EXPECT_EQ(problemOf(std::string(std::size_t(60000000), 'x')), "");
    EXPECT_EQ(problemOf(std::string(std::size_t(70000000), 'x')).substr(0, 27),
              "f: its bytes need about 134");
}
