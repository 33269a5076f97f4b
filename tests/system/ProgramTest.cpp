// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/system/Machine.h>
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(Program, KnowsItself) {
    EXPECT_TRUE(std::filesystem::is_regular_file(programPath()));
    EXPECT_TRUE(std::filesystem::equivalent(libraryPath(), programPath()))
        << "this program has the library inside";
    EXPECT_GT(processId(), 0);
    EXPECT_FALSE(hasEnded(processId()));
    EXPECT_FALSE(hostName().empty());
}

TEST(Program, UsesMemory) {
    EXPECT_GT(residentBytes(), 1e6);
    EXPECT_GT(addressSpace(), std::uint64_t(1) << 20);
    EXPECT_GT(availableMemory(), std::uint64_t(1) << 26);
}

TEST(Program, ReadsTheEnvironment) {
    const EnvironmentVariable variable("OSGTREEWIND_TEST", "сосна");
    EXPECT_EQ(environmentVariable("OSGTREEWIND_TEST"), "сосна");
    EXPECT_FALSE(environmentVariable("OSGTREEWIND_TEST_MISSING"));
}

TEST(Program, SearchesThePathButNotTheCurrentFolder) {
    const TemporaryFolder folder;
    const std::string program = folder.write(std::string("some-program") + programSuffix, "");
    std::filesystem::permissions(toPath(program), std::filesystem::perms::owner_all);
    const std::string before = environmentVariable("PATH").value_or("");
    const std::filesystem::path current = std::filesystem::current_path();
    std::filesystem::current_path(toPath(folder.path()));
    EXPECT_EQ(findProgram("some-program"), "");
    {
        const EnvironmentVariable path("PATH", (std::string(".") + listSeparator + before).c_str());
        EXPECT_EQ(findProgram("some-program"), "") << "a relative folder";
    }
    {
        const EnvironmentVariable path("PATH", (before + listSeparator + folder.path()).c_str());
        EXPECT_TRUE(std::filesystem::equivalent(toPath(findProgram("some-program")), toPath(program)));
    }
    std::filesystem::current_path(current);
}

} // namespace osgTreeWind
