// SPDX-License-Identifier: MIT
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/system/File.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace osgTreeWind {

TEST(File, VanishesWhenItIsClosed) {
    const TemporaryFolder folder;
    FilePointer file = openVanishingFile(folder.path()), other = openVanishingFile(folder.path());
    ASSERT_TRUE(file && other);
    EXPECT_EQ(std::fputs("text", file.get()) >= 0, true);
    ASSERT_TRUE(seekFile(file.get(), 1));
    EXPECT_EQ(std::fgetc(file.get()), 'e');
    EXPECT_EQ(std::fgetc(other.get()), EOF) << "each is a file of its own";
    file.reset();
    other.reset();
    EXPECT_EQ(folder.countFiles(), 0u);
    EXPECT_FALSE(openVanishingFile(folder.path() + "/missing"));
}

TEST(File, IsReadBeyondTwoGigabytes) {
    const TemporaryFolder folder;
    const FilePointer file = openVanishingFile(folder.path());
    constexpr std::int64_t far = std::int64_t(3) << 30; // the hole takes no room on the disk
    ASSERT_TRUE(file && seekFile(file.get(), far));
    ASSERT_EQ(std::fputc('x', file.get()), 'x');
    ASSERT_TRUE(seekFile(file.get(), far));
    EXPECT_EQ(std::fgetc(file.get()), 'x');
}

TEST(File, IsRemovedWhileItIsWritten) {
    const TemporaryFolder folder;
    const std::string file = folder.path() + "/лес.part", world = folder.path() + "/мир";
    std::filesystem::create_directory(toPath(world));
    std::ofstream one(toPath(file)), other(toPath(world + "/tile"));
    one << "half" << std::flush;
    removeUnfinished(file);
    removeUnfinished(world);
    EXPECT_EQ(folder.countFiles(), 0u);
}

TEST(File, IsWrittenIntoFolders) {
    const TemporaryFolder folder;
    EXPECT_TRUE(mayWriteInto(folder.path()));
    EXPECT_FALSE(mayWriteInto(folder.path() + "/missing"));
}

TEST(File, OnWindowsMayBeHeldOpen) {
    const TemporaryFolder folder;
    const std::string path = folder.write("held.txt", "text");
    EXPECT_FALSE(isHeldOpen(path));
    const std::ifstream holder(toPath(path));
    EXPECT_EQ(isHeldOpen(path), listSeparator == ';');
}

} // namespace osgTreeWind
