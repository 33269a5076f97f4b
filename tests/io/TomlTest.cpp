// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/Toml.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

/// Malformed text that violates assertions of toml++ 3.3 and 3.4, which compilers take for granted where
/// NDEBUG is set.
TEST(TomlTest, ReportsTextThatViolatesAssertionsOfTheParser) {
    struct Case {
        const char* text;
        int line, column;
    };
    const Case cases[] = {{"[=]", 1, 2},           {"a = 1\n[[=]]", 2, 3}, {"[.]", 1, 2},
                          {"[é]", 1, 2},           {"a = é", 1, 5},        {"a = 3 é", 1, 7},
                          {"a = [é", 1, 6},        {"é = 1", 1, 1},        {"a = 1\n b = é1", 2, 6},
                          {"a = { é = 1 }", 1, 7}, {"[,+z", 1, 2},         {"[\\", 1, 2}};
    for (const Case& wrong : cases) {
        SCOPED_TRACE(wrong.text);
        const Result<toml::table> document = parseToml(wrong.text, "a file");
        ASSERT_FALSE(document);
        const Diagnostic& problem = document.problems().front();
        EXPECT_EQ(problem.file, "a file");
        EXPECT_EQ(problem.line, wrong.line);
        EXPECT_EQ(problem.column, wrong.column);
        EXPECT_EQ(problem.message.find("not valid TOML: "), 0u) << problem.message;
    }
}

TEST(TomlTest, OffsetsCountBytesAndColumnsCountCharacters) {
    const std::string text = "a = 1\n\"é\" = \"ü\" # ö\nb = 2";
    EXPECT_EQ(lineBegin(text, 2), 6u);
    EXPECT_EQ(lineBegin(text, 9), text.size());
    const Result<toml::table> document = parseToml(text);
    ASSERT_TRUE(document.ok());
    const toml::source_region& value = document.value().get("é")->source();
    EXPECT_EQ(
        text.substr(offsetOf(text, value.begin), offsetOf(text, value.end) - offsetOf(text, value.begin)),
        "\"ü\"");
}

} // namespace osgTreeWind
