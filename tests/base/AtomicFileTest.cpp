// SPDX-License-Identifier: MIT
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

using namespace osgTreeWind;

namespace {

std::size_t filesIn(const std::string& folder) {
    const std::filesystem::directory_iterator first(folder);
    return static_cast<std::size_t>(std::distance(first, {}));
}

} // namespace

TEST(AtomicFile, KeepsTheOldFileUntilCommit) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "before");
    {
        AtomicFile file(path);
        std::ofstream(file.writePath()) << "half";
        EXPECT_EQ(bytesOf(path), "before");
    }
    EXPECT_EQ(bytesOf(path), "before");
    EXPECT_EQ(filesIn(folder.path()), 1u) << "the temporary file is removed";
    EXPECT_TRUE(writeFileAtomically(path, "after").empty());
    EXPECT_EQ(bytesOf(path), "after");
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

#ifndef _WIN32 // where links need a right, and devices are no files
TEST(AtomicFile, WritesThroughLinksAndIntoDevices) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", "before"), link = folder.path() + "/link";
    std::filesystem::create_symlink(path, link);
    EXPECT_TRUE(writeFileAtomically(link, "after").empty());
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(bytesOf(path), "after");
    EXPECT_TRUE(writeFileAtomically("/dev/null", "nothing").empty());
    EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}
#endif

TEST(AtomicFile, ReportsWhyAFileCannotBeWritten) {
    const TemporaryFolder folder;
    const std::string path = folder.path();
    EXPECT_EQ(toString(writeFileAtomically(path + "/no/a", "text")),
              path + "/no/a: cannot be written: there is no folder " + path + "/no");
    EXPECT_EQ(toString(writeFileAtomically(path, "text")), path + ": cannot be written: it is a folder");
#ifdef __linux__
    EXPECT_EQ(toString(writeFileAtomically("/dev/full", "text")), "/dev/full: cannot be written");
#endif
    EXPECT_EQ(filesIn(path), 0u);
}

TEST(AtomicFile, ThreadsMayWriteTheSameFile) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/a";
    std::atomic<int> failed{0};
    std::vector<std::thread> threads;
    for (int thread = 0; thread < 8; ++thread)
        threads.emplace_back([&, thread] {
            for (int i = 0; i < 30; ++i)
                failed +=
                    !writeFileAtomically(path, std::string(5000, static_cast<char>('a' + thread))).empty();
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(failed, 0);
    EXPECT_EQ(bytesOf(path), std::string(5000, bytesOf(path)[0]));
    EXPECT_EQ(filesIn(folder.path()), 1u);
}

TEST(AtomicFile, RemovesTemporaryFilesOfKilledProcesses) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/a";
    std::string left;
    {
        const AtomicFile file(path);
        left = file.writePath();
    }
    const std::string own = std::to_string(processId());
    folder.write("b.txt.part", "a user's file");
    std::ofstream(left) << "of a running process";
    left.replace(left.rfind('-' + own + '-') + 1, own.size(), "99999999"); // no process has this number
    std::ofstream(left) << "half";
    const TemporaryFolder other; // a folder is searched only once
    for (const std::filesystem::directory_entry& file : std::filesystem::directory_iterator(folder.path()))
        other.write(file.path().filename().string(), bytesOf(file.path().string()));
    ASSERT_EQ(filesIn(other.path()), 3u);
    EXPECT_TRUE(writeFileAtomically(other.path() + "/c", "text").empty());
    EXPECT_EQ(filesIn(other.path()), 3u) << "one was removed, one was added";
}
