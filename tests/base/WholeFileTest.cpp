// SPDX-License-Identifier: MIT
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/WholeFile.h>

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include <unistd.h>

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
    EXPECT_TRUE(writeWholeFile(path, "after").empty());
    EXPECT_EQ(bytesOf(path), "after");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WholeFile, WritesWhereALinkLeadsAndIntoDevices) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "before"), link = folder.path() + "/link";
    std::filesystem::create_symlink(path, link);
    EXPECT_TRUE(writeWholeFile(link, "after").empty());
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(bytesOf(path), "after");
    EXPECT_TRUE(writeWholeFile("/dev/null", "nothing").empty());
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WholeFile, WhereNothingCanBeWrittenItSaysWhy) {
    const TemporaryFolder folder;
    const std::string place = folder.path();
    EXPECT_EQ(linesOf(writeWholeFile(place + "/no/a", "text")),
              place + "/no/a: cannot be written: there is no folder " + place + "/no");
    EXPECT_EQ(linesOf(writeWholeFile(place, "text")), place + ": cannot be written: it is a folder");
    EXPECT_EQ(linesOf(writeWholeFile("/dev/full", "text")), "/dev/full: cannot be written");
    EXPECT_EQ(filesIn(place), 0u);
}

TEST(WholeFile, ManyThreadsMayWriteOneName) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/a";
    std::atomic<int> failed{0};
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 8; ++thread)
        threads.emplace_back([&, thread] {
            for (int i = 0; i < 30; ++i)
                failed += !writeWholeFile(path, std::string(5000, static_cast<char>('a' + thread))).empty();
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(bytesOf(path), std::string(5000, bytesOf(path)[0]));
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(WholeFile, RemovesWhatAKilledProgramLeft) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/a";
    std::string left;
    {
        const WholeFile file(path);
        left = file.unfinished();
    }
    const std::string own = std::to_string(getpid());
    folder.write("b.txt.part", "a person's");
    std::ofstream(left) << "of a process that lives";
    left.replace(left.rfind('-' + own + '-') + 1, own.size(), "99999999"); // no process has this number
    std::ofstream(left) << "half";
    const TemporaryFolder other; // folders are looked into once
    std::filesystem::copy(folder.path(), other.path());
    ASSERT_EQ(filesIn(other.path()), 3u);
    EXPECT_TRUE(writeWholeFile(other.path() + "/c", "text").empty());
    EXPECT_EQ(filesIn(other.path()), 3u) << "one is gone, one has come";
}
