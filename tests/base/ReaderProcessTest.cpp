// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/ReaderProcess.h>
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

#include <chrono>

namespace osgTreeWind {

namespace {

constexpr ReaderProgram reader{"test_reader", "OSGTREEWIND_TEST_READER", "test", "nothing"};

class ReaderProcessTest : public testing::Test {
protected:
    template <typename T>
    Result<T> read(const std::vector<std::string>& task) const {
        std::vector<std::string> arguments = {_file};
        arguments.insert(arguments.end(), task.begin(), task.end());
        return readWithProgram<T>(reader, arguments);
    }
    std::string problemOf(const std::string& task) const { return firstProblem(read<std::size_t>({task})); }

private:
    const std::string _program = toText(programPath().parent_path() / "test_reader") + programSuffix;
    const EnvironmentVariable _variable{reader.variable, _program.c_str()};
    const TemporaryFolder _folder;
    const std::string _file = _folder.write("a file.txt", "content");
};

} // namespace

TEST_F(ReaderProcessTest, PassesArguments) {
    const std::vector<std::string> hard = {"arguments",     "",    "two words", "a \"quote\"",
                                           "back\\slash\\", "лес", "a\\\"b"};
    const auto received = read<std::vector<std::string>>(hard);
    ASSERT_TRUE(received) << firstProblem(received);
    EXPECT_EQ(std::vector<std::string>(received.value().begin() + 2, received.value().end()), hard);
}

TEST_F(ReaderProcessTest, EndsAReaderWhoseTimeIsUp) {
    const auto start = std::chrono::steady_clock::now();
    EXPECT_NE(problemOf("time").find("the test file is damaged: its reader timed out"), std::string::npos)
        << problemOf("time");
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST_F(ReaderProcessTest, LimitsTheMemoryOfAReader) {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "AddressSanitizer ends a program that is out of memory";
#endif
    const auto bytes = read<std::size_t>({"memory"});
    if (!bytes && firstProblem(bytes).find("its reader ran out of memory") != std::string::npos)
        return; // Wine
    ASSERT_TRUE(bytes) << firstProblem(bytes);
    EXPECT_GT(bytes.value(), std::size_t(1) << 26);
    EXPECT_LE(bytes.value(), std::size_t(1) << 28);
}

TEST_F(ReaderProcessTest, ReportsACrash) {
    const std::string problem = problemOf("crash");
    EXPECT_NE(problem.find("its reader ended with: "), std::string::npos) << problem;
}

TEST_F(ReaderProcessTest, ReportsAStatus) {
    EXPECT_NE(problemOf("status").find("its reader ended with status 3"), std::string::npos)
        << problemOf("status");
}

TEST_F(ReaderProcessTest, EndsAReaderThatWaits) {
    ReaderProcess process(reader, {"file", "echo"});
    ASSERT_TRUE(process.started()) << process.problem();
    char byte = 'x';
    ASSERT_EQ(writeSome(process.descriptor(), &byte, 1), 1);
    byte = '\0';
    ASSERT_EQ(readSome(process.descriptor(), &byte, 1), 1);
    EXPECT_EQ(byte, 'x');
    EXPECT_EQ(process.problem(), "its reader ended with status 0");
}

TEST(ReaderProcess, NamesAMissingProgram) {
    const EnvironmentVariable missing(reader.variable, "/nowhere/reader");
    ReaderProcess process(reader, {"file"});
    EXPECT_FALSE(process.started());
    EXPECT_EQ(process.problem().rfind("test needs nothing, and the program /nowhere/reader: ", 0), 0u)
        << process.problem();
}

} // namespace osgTreeWind
