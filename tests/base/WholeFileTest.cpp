// SPDX-License-Identifier: MIT
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/WholeFile.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace osgTreeWind;

namespace {

std::size_t filesIn(const std::string& folder) {
    const std::filesystem::directory_iterator first(folder);
    return static_cast<std::size_t>(std::distance(first, {}));
}

} // namespace

TEST(WholeFile, WhatWasThereStaysUntilTheNewOneIsWhole) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "before");
    {
        WholeFile file(path);
        std::ofstream(file.unfinished()) << "half";
        EXPECT_EQ(bytesOf(path), "before");
    }
    EXPECT_EQ(bytesOf(path), "before");
    EXPECT_EQ(filesIn(folder.path()), 1u) << "what was begun is gone";
    EXPECT_TRUE(writeWholeFile(path, "after"));
    EXPECT_EQ(bytesOf(path), "after");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WholeFile, WritesWhereALinkLeadsAndIntoDevices) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "before"), link = folder.path() + "/link";
    std::filesystem::create_symlink(path, link);
    EXPECT_TRUE(writeWholeFile(link, "after"));
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(bytesOf(path), "after");
    EXPECT_TRUE(writeWholeFile("/dev/null", "nothing"));
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WholeFile, WhereNothingCanBeWrittenItSaysSo) {
    const TemporaryFolder folder;
    EXPECT_FALSE(writeWholeFile(folder.path() + "/no/a", "text"));
    EXPECT_FALSE(writeWholeFile(folder.path(), "text")) << "a folder";
}
