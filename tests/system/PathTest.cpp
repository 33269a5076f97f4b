// SPDX-License-Identifier: MIT
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

const bool isWindows = listSeparator == ';';

} // namespace

TEST(Path, NamesFilesInAnyAlphabet) {
    const TemporaryFolder folder;
    for (const std::string& name :
         std::vector<std::string>{"лес.treewind", "Bäume und Höhe.csv", "森.trees", std::string(200, 'a')}) {
        const std::string path = folder.path() + "/" + name;
        std::ofstream(toPath(path)) << "content";
        EXPECT_TRUE(fs::is_regular_file(toPath(path))) << name;
        EXPECT_EQ(toText(toPath(path).filename()), name);
    }
    std::size_t found = 0;
    for (const auto& file : fs::directory_iterator(toPath(folder.path())))
        found += toText(file.path()).find("лес.treewind") != std::string::npos;
    EXPECT_EQ(found, 1u);
}

TEST(Path, KeepsBytesThatAreNoText) {
    EXPECT_EQ(toText(toPath("a\xff")), isWindows ? "a\xef\xbf\xbd" : "a\xff");
}

TEST(Path, HasParts) {
    EXPECT_EQ(folderOf("a/b.c/d.e.f"), "a/b.c");
    EXPECT_EQ(folderOf("d.e"), "");
    EXPECT_EQ(extensionOf("a/b.c/d.e.f"), ".f");
    EXPECT_EQ(stemOf("a/b.c/d.e.f"), "d.e");
    EXPECT_EQ(pathIn("a/b", "../c"), "a/c");
    EXPECT_EQ(pathIn("a", isWindows ? "C:/c" : "/c"), isWindows ? "C:/c" : "/c");
}

TEST(Path, IsResolved) {
    const TemporaryFolder folder;
    fs::create_directories(toPath(folder.path() + "/Inner"));
    const std::string file = folder.write("Inner/file.txt", "");
    EXPECT_EQ(resolved(toPath(folder.path() + "/Inner/../Inner/./file.txt")), resolved(toPath(file)));
    EXPECT_FALSE(resolved(toPath(file)).empty());
    EXPECT_TRUE(resolved(toPath(folder.path() + "/missing")).empty());
    const std::filesystem::path otherCase = resolved(toPath(folder.path() + "/INNER/FILE.TXT"));
    EXPECT_EQ(otherCase, isWindows ? resolved(toPath(file)) : fs::path());
}

TEST(Path, OnWindowsRefusesNamesOfDevicesAndStreams) {
    for (const std::string name : {"NUL", "nul.csv", "trees/COM1", "com1 .txt", "C:/folder/Aux.trees",
                                   "CONIN$", "LPT9", "a.csv:stream", "C:/a.csv:b", "C:trees.csv", "c:",
                                   "\\\\?\\C:\\a.csv:b", "\\\\.\\pipe\\x", "//./COM10", "\\??\\C:\\a.csv"})
        EXPECT_EQ(problemOfName(name).empty(), !isWindows) << name;
    for (const std::string name :
         {"C:/trees.csv", "c:\\trees.csv", "../trees.csv", "COMMON.csv", "null.csv", "com.csv",
          "/absolute/path", "COM10", "//server/share/a.csv", "\\\\?\\C:\\a.csv"})
        EXPECT_EQ(problemOfName(name), "") << name;
}

TEST(Path, OnWindowsTellsOtherMachines) {
    for (const std::string name : {"//server/share/a.csv", "\\\\server\\share\\a.csv", "\\\\?\\C:\\a.csv",
                                   "/\\server\\share", "\\??\\UNC\\server\\share"})
        EXPECT_EQ(leavesTheMachine(name), isWindows) << name;
    for (const std::string name : {"C:/a.csv", "/a.csv", "a//b.csv", ""})
        EXPECT_FALSE(leavesTheMachine(name)) << name;
}

} // namespace osgTreeWind
