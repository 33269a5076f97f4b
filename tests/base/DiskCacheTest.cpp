// SPDX-License-Identifier: MIT
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/base/DiskCache.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#ifndef _WIN32
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace osgTreeWind {
namespace {

namespace files = std::filesystem;

constexpr std::uint64_t plenty = 1'000'000;

std::vector<files::path> entriesOf(const std::string& folder) {
    std::vector<files::path> all;
    for (const files::directory_entry& entry : files::directory_iterator(folder))
        all.push_back(entry.path());
    return all;
}

std::uint64_t sizeOf(const std::string& folder) {
    std::uint64_t sum = 0;
    for (const files::path& file : entriesOf(folder))
        sum += files::file_size(file);
    return sum;
}

/// Value of a key; sizes vary.
std::string valueOf(int key) {
    return std::string(static_cast<std::size_t>(1000 + 37 * key % 5000), static_cast<char>('a' + key % 26));
}

std::string keyOf(int key) {
    return "key " + std::to_string(key);
}

/// Stores and finds a few hundred values. @return whether each value found belongs to its key.
bool storeAndFind(const DiskCache& cache) {
    bool right = true;
    for (int i = 0; i < 400; ++i) {
        cache.store(keyOf(i % 23), valueOf(i % 23));
        const auto found = cache.find(keyOf((7 * i) % 23));
        right = right && (!found || *found == valueOf((7 * i) % 23));
    }
    return right;
}

} // namespace

TEST(DiskCache, FindsStoredValues) {
    const TemporaryFolder folder;
    const std::string path = folder.path() + "/new/one";
    const DiskCache cache(path, plenty);
    EXPECT_FALSE(cache.find("a"));
    const std::string binary("\0\xff\n", 3);
    cache.store("a", "first");
    cache.store(binary, binary);
    cache.store("empty", "");
    EXPECT_EQ(cache.find("a"), "first");
    EXPECT_EQ(cache.find(binary), binary);
    EXPECT_EQ(cache.find("empty"), "");
    cache.store("a", "second");
    EXPECT_EQ(DiskCache(path, plenty).find("a"), "second");
    EXPECT_EQ(entriesOf(path).size(), 3u);
}

TEST(DiskCache, IgnoresAndReplacesDamagedFiles) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), plenty);
    cache.store("key", "a value");
    const std::string file = entriesOf(folder.path()).front().string(), whole = bytesOf(file);
    const auto holds = [&](const std::string& content) {
        std::ofstream(file, std::ios::binary) << content;
        return cache.find("key").has_value();
    };
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_FALSE(holds(whole.substr(0, i))) << "cut at " << i;
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        EXPECT_FALSE(holds(damaged)) << "byte " << i;
    }
    EXPECT_FALSE(holds(whole + "more"));
    EXPECT_FALSE(holds("an unrelated text that is longer than the header and the key of a cache file"));
    cache.store("key", "another value");
    EXPECT_EQ(cache.find("key"), "another value");
}

TEST(DiskCache, IgnoresTheFileOfAnotherKey) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), plenty);
    cache.store("one", "1");
    const files::path first = entriesOf(folder.path()).front();
    const std::string content = bytesOf(first.string());
    cache.store("two", "2");
    for (const files::path& file : entriesOf(folder.path()))
        if (file != first)
            std::ofstream(file, std::ios::binary) << content;
    EXPECT_FALSE(cache.find("two")) << "the hashes of two keys may collide";
    EXPECT_EQ(cache.find("one"), "1");
}

TEST(DiskCache, StaysBelowItsLimitAndEvictsTheLeastRecentlyUsed) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), 10'000);
    const std::string foreign = folder.write("foreign.txt", std::string(20'000, 'x'));
    const auto storeUsedAgo = [&](const std::string& key, int hours) {
        cache.store(key, std::string(3000, 'x'));
        for (const files::path& file : entriesOf(folder.path()))
            if (bytesOf(file.string()).find(key) != std::string::npos)
                files::last_write_time(file, files::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    storeUsedAgo("first", 3);
    storeUsedAgo("second", 2);
    storeUsedAgo("third", 1);
    EXPECT_TRUE(cache.find("first")) << "now the most recently used";
    cache.store("fourth", std::string(3000, 'x'));
    EXPECT_FALSE(cache.find("second"));
    EXPECT_TRUE(cache.find("first"));
    EXPECT_TRUE(cache.find("third"));
    EXPECT_TRUE(cache.find("fourth"));
    for (int i = 0; i < 50; ++i) {
        cache.store(keyOf(i), valueOf(i));
        EXPECT_LE(sizeOf(folder.path()), 10'000u + files::file_size(foreign));
        EXPECT_TRUE(cache.find(keyOf(i)));
    }
    cache.store("too large by itself", std::string(10'001, 'x'));
    EXPECT_FALSE(cache.find("too large by itself"));
    EXPECT_TRUE(cache.find(keyOf(49)));
    EXPECT_TRUE(files::exists(foreign));
}

TEST(DiskCache, RemovesStaleTemporaryFiles) {
    const TemporaryFolder folder;
    const std::string young = folder.write("a.cache.1.part", "x"), old = folder.write("b.cache.2.part", "x");
    files::last_write_time(old, files::file_time_type::clock::now() - std::chrono::hours(2));
    DiskCache(folder.path(), plenty).store("key", "value");
    EXPECT_TRUE(files::exists(young)) << "another program may be writing it";
    EXPECT_FALSE(files::exists(old));
}

TEST(DiskCache, ServesManyThreadsAndProgramsAtOnce) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), 20'000); // small, so that files are evicted all the time
#ifndef _WIN32                                    // which has no fork()
    std::vector<pid_t> programs;
    for (int i = 0; i < 3; ++i)
        if (const pid_t program = fork(); program == 0)
            _exit(storeAndFind(cache) ? 0 : 1);
        else
            programs.push_back(program);
#endif
    std::vector<std::thread> threads;
    std::vector<char> right(3, false);
    for (char& each : right)
        threads.emplace_back([&] { each = storeAndFind(cache); });
    for (std::thread& thread : threads)
        thread.join();
#ifndef _WIN32
    for (const pid_t program : programs) {
        int status = 1;
        EXPECT_EQ(waitpid(program, &status, 0), program);
        EXPECT_EQ(status, 0);
    }
#endif
    EXPECT_EQ(right, std::vector<char>(3, true));
    for (const files::path& file : entriesOf(folder.path()))
        EXPECT_EQ(file.extension(), ".cache") << file;
}

TEST(DiskCache, StoresNothingInAnUnwritableFolder) {
    const TemporaryFolder folder;
    const std::string file = folder.write("file", "x");
    for (const std::string& path :
         {std::string(), file, file + "/below", std::string("/proc/no"), std::string("/dev/full")}) {
        const DiskCache cache(path, plenty);
        cache.store("key", "value");
        EXPECT_FALSE(cache.find("key")) << path;
    }
    EXPECT_EQ(bytesOf(file), "x");
}

#ifndef _WIN32 // which limits no file sizes
TEST(DiskCache, LeavesNoPartialFileOnAFullDisk) {
    const TemporaryFolder folder;
    const DiskCache cache(folder.path(), plenty);
    // A child process with a limited file size.
    const pid_t program = fork();
    if (program == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{2000, 2000};
        setrlimit(RLIMIT_FSIZE, &limit);
        cache.store("large", std::string(100'000, 'x'));
        cache.store("small", "fits");
        _exit(cache.find("large") || cache.find("small") != "fits" ? 1 : 0);
    }
    int status = 1;
    waitpid(program, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(entriesOf(folder.path()).size(), 1u);
}
#endif

} // namespace osgTreeWind
