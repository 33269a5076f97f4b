// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>
#include <tests/base/FirstProblem.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/Trust.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

using namespace osgTreeWind;

namespace {

std::string problemOfWindFile(const TemporaryFolder& folder, const std::string& name) {
    std::filesystem::create_directories(folder.path() + "/forest");
    const std::string file = folder.write(
        "forest/f.treewind", "version = 1\n[[tree]]\nposition = [0, 0]\n[wind]\n"
                             "kind = \"series\"\nfile = \"" +
                                 name + "\"\ncolumns = { time = \"t\", u = \"u\", v = \"v\" }\n");
    return firstProblem(readForestFile(file));
}

void expectOutside(const std::string& problem) {
    EXPECT_NE(problem.find("is not opened: it lies outside the folders that OSGTREEWIND_TRUST=folder trusts"),
              std::string::npos)
        << problem;
}

const char* const record = "t,u,v\n0,1,2\n";

} // namespace

TEST(Trust, AllowsAnyFileByDefault) {
    const TemporaryFolder folder;
    folder.write("wind.csv", record);
    EXPECT_EQ(problemOfWindFile(folder, "../wind.csv"), "");
    EXPECT_EQ(problemOfWindFile(folder, folder.path() + "/wind.csv"), "");
}

TEST(Trust, FolderModeOpensOnlyFilesInTrustedFolders) {
    const TemporaryFolder folder;
    folder.write("wind.csv", record);
    std::filesystem::create_directories(folder.path() + "/forest/data");
    folder.write("forest/data/wind.csv", record);
    const EnvironmentVariable trust("OSGTREEWIND_TRUST", "folder");
    EXPECT_EQ(problemOfWindFile(folder, "data/wind.csv"), "");
    EXPECT_EQ(problemOfWindFile(folder, "data/../data/wind.csv"), "");
    for (const std::string& name :
         {std::string("../wind.csv"), folder.path() + "/wind.csv", std::string("data/../../wind.csv")})
        expectOutside(problemOfWindFile(folder, name));
    setEnvironment("OSG_FILE_PATH", folder.path().c_str());
    EXPECT_EQ(problemOfWindFile(folder, "../wind.csv"), "") << "OSG_FILE_PATH is trusted";
    unsetEnvironment("OSG_FILE_PATH");
}

TEST(Trust, OnWindowsRefusesNamesThatAreNoFiles) {
    const TemporaryFolder folder;
    const bool isWindows = listSeparator == ';';
    for (const std::string name : {"NUL", "data/com1.csv", "wind.csv:stream", "C:wind.csv", "CONIN$",
                                   "data/AUX ", R"(\\\\.\\pipe\\wind)"}) {
        const std::string problem = problemOfWindFile(folder, name);
        EXPECT_NE(problem.find(isWindows ? "expected a" : "no file"), std::string::npos) << problem;
    }
}

TEST(Trust, OnWindowsFolderModeLooksForNoOtherMachine) {
    const TemporaryFolder folder;
    folder.write("wind.csv", record);
    const EnvironmentVariable trust("OSGTREEWIND_TRUST", "folder");
    const auto start = std::chrono::steady_clock::now();
    for (const std::string name :
         {"//192.0.2.1/share/wind.csv", R"(\\\\192.0.2.1\\share\\wind.csv)", R"(\\\\?\\C:\\wind.csv)"}) {
        const std::string problem = problemOfWindFile(folder, name);
        EXPECT_NE(problem.find(listSeparator == ';' ? "is not opened: it lies outside" : "no file"),
                  std::string::npos)
            << problem;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5)) << "it waits for no network";
}

TEST(Trust, OnWindowsFolderModeIgnoresCase) {
    if (listSeparator != ';')
        GTEST_SKIP() << "file names have a case here";
    const TemporaryFolder folder;
    folder.write("outside.csv", record);
    problemOfWindFile(folder, "");
    folder.write("forest/wind.csv", record);
    const EnvironmentVariable trust("OSGTREEWIND_TRUST", "folder");
    EXPECT_EQ(problemOfWindFile(folder, "WIND.CSV"), "");
    EXPECT_EQ(problemOfWindFile(folder, "../FOREST/wind.csv"), "");
    EXPECT_NE(problemOfWindFile(folder, "../OUTSIDE.CSV"), "");
}

TEST(Trust, UnknownModeOpensNothing) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() + "/forest");
    folder.write("forest/wind.csv", record);
    const EnvironmentVariable trust("OSGTREEWIND_TRUST", "Folder");
    EXPECT_NE(
        problemOfWindFile(folder, "wind.csv").find("expected OSGTREEWIND_TRUST to be \"folder\" or empty"),
        std::string::npos);
}

#ifndef _WIN32 // where links need a right, and libstdc++ makes none
TEST(Trust, FolderModeFollowsLinks) {
    const TemporaryFolder folder;
    folder.write("wind.csv", record);
    std::filesystem::create_directories(folder.path() + "/forest/data");
    folder.write("forest/data/wind.csv", record);
    std::filesystem::create_symlink(folder.path() + "/wind.csv", folder.path() + "/forest/link.csv");
    std::filesystem::create_symlink(folder.path() + "/forest/data/wind.csv",
                                    folder.path() + "/forest/good.csv");
    const EnvironmentVariable trust("OSGTREEWIND_TRUST", "folder");
    EXPECT_EQ(problemOfWindFile(folder, "good.csv"), "");
    expectOutside(problemOfWindFile(folder, "link.csv"));
}

TEST(Trust, FolderModeRejectsSiblingsThatLinkOutside) {
    const TemporaryFolder folder;
    std::filesystem::create_directories(folder.path() + "/forest");
    folder.write("forest/wind.csv", record);
    folder.write("secret.prj", "");
    std::filesystem::create_symlink(folder.path() + "/secret.prj", folder.path() + "/forest/windy.prj");
    const EnvironmentVariable trust("OSGTREEWIND_TRUST", "folder");
    EXPECT_EQ(problemOfWindFile(folder, "wind.csv"), "") << "the link has another base name";
    std::filesystem::create_symlink(folder.path() + "/secret.prj", folder.path() + "/forest/wind.prj");
    EXPECT_NE(
        problemOfWindFile(folder, "wind.csv").find("a symbolic link next to it leads out of the folders"),
        std::string::npos);
}
#endif
