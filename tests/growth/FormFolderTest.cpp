// SPDX-License-Identifier: MIT
#include <tests/io/FileBytes.h>
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/growth/FormFolder.h>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// What belongs to a key, of many sizes.
std::string valueOf(int key) {
    return std::string(static_cast<std::size_t>(1000 + 37 * key % 5000), static_cast<char>('a' + key % 26));
}

std::string keyOf(int key) {
    return "key " + std::to_string(key);
}

/// Whether a few hundred calls find nothing that does not belong to its key.
bool keepsAndFinds(const FormFolder& folder) {
    bool right = true;
    for (int i = 0; i < 400; ++i) {
        folder.keep(keyOf(i % 23), valueOf(i % 23));
        const auto found = folder.find(keyOf((7 * i) % 23));
        right = right && (!found || *found == valueOf((7 * i) % 23));
    }
    return right;
}

} // namespace

TEST(FormFolder, FindsWhatItKeeps) {
    const TemporaryFolder place;
    const FormFolder folder(place.path() + "/new/one", plenty);
    EXPECT_FALSE(folder.find("a"));
    const std::string binary("\0\xff\n", 3);
    folder.keep("a", "first");
    folder.keep(binary, binary);
    folder.keep("empty", "");
    EXPECT_EQ(folder.find("a"), "first");
    EXPECT_EQ(folder.find(binary), binary);
    EXPECT_EQ(folder.find("empty"), "");
    folder.keep("a", "second");
    EXPECT_EQ(FormFolder(folder.path(), plenty).find("a"), "second");
    EXPECT_EQ(entriesOf(folder.path()).size(), 3u);
}

TEST(FormFolder, ADamagedFileIsNotThereAndIsWrittenAnew) {
    const TemporaryFolder place;
    const FormFolder folder(place.path(), plenty);
    folder.keep("key", "a value");
    const std::string file = entriesOf(place.path()).front().string(), whole = bytesOf(file);
    const auto holds = [&](const std::string& content) {
        std::ofstream(file, std::ios::binary) << content;
        return folder.find("key").has_value();
    };
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_FALSE(holds(whole.substr(0, i))) << "cut at " << i;
        std::string damaged = whole;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        EXPECT_FALSE(holds(damaged)) << "byte " << i;
    }
    EXPECT_FALSE(holds(whole + "more"));
    EXPECT_FALSE(holds("something else altogether, which is longer than what a file of ours begins with"));
    folder.keep("key", "another value");
    EXPECT_EQ(folder.find("key"), "another value");
}

TEST(FormFolder, AFileOfAnotherKeyIsNotTaken) {
    const TemporaryFolder place;
    const FormFolder folder(place.path(), plenty);
    folder.keep("one", "1");
    const files::path first = entriesOf(place.path()).front();
    files::copy_file(first, place.path() + "/kept");
    folder.keep("two", "2");
    for (const files::path& file : entriesOf(place.path()))
        if (file != first && file.extension() == first.extension())
            files::copy_file(place.path() + "/kept", file, files::copy_options::overwrite_existing);
    EXPECT_FALSE(folder.find("two")) << "names of files may be alike by chance";
    EXPECT_EQ(folder.find("one"), "1");
}

TEST(FormFolder, HoldsNoMoreThanItMayAndForgetsTheOldestUseFirst) {
    const TemporaryFolder place;
    const FormFolder folder(place.path(), 10'000);
    const std::string foreign = place.write("of somebody else.txt", std::string(20'000, 'x'));
    const auto before = [&](const std::string& key, int hours) { // that it was last used
        folder.keep(key, std::string(3000, 'x'));
        for (const files::path& file : entriesOf(place.path()))
            if (bytesOf(file.string()).find(key) != std::string::npos)
                files::last_write_time(file, files::file_time_type::clock::now() - std::chrono::hours(hours));
    };
    before("first", 3);
    before("second", 2);
    before("third", 1);
    EXPECT_TRUE(folder.find("first")) << "which is now used last";
    folder.keep("fourth", std::string(3000, 'x'));
    EXPECT_FALSE(folder.find("second"));
    EXPECT_TRUE(folder.find("first"));
    EXPECT_TRUE(folder.find("third"));
    EXPECT_TRUE(folder.find("fourth"));
    for (int i = 0; i < 50; ++i) {
        folder.keep(keyOf(i), valueOf(i));
        EXPECT_LE(sizeOf(place.path()), 10'000u + files::file_size(foreign));
        EXPECT_TRUE(folder.find(keyOf(i)));
    }
    folder.keep("too large by itself", std::string(10'001, 'x'));
    EXPECT_FALSE(folder.find("too large by itself"));
    EXPECT_TRUE(folder.find(keyOf(49)));
    EXPECT_TRUE(files::exists(foreign));
}

TEST(FormFolder, WhatAnEndedProgramLeftGoesAfterAWhile) {
    const TemporaryFolder place;
    const std::string young = place.write("a.form.1.part", "x"), old = place.write("b.form.2.part", "x");
    files::last_write_time(old, files::file_time_type::clock::now() - std::chrono::hours(2));
    FormFolder(place.path(), plenty).keep("key", "value");
    EXPECT_TRUE(files::exists(young)) << "it may be being written";
    EXPECT_FALSE(files::exists(old));
}

TEST(FormFolder, ManyThreadsAndProgramsUseItAtOnce) {
    const TemporaryFolder place;
    const FormFolder folder(place.path(), 20'000); // so that files go all the time
    std::vector<pid_t> programs;
    for (int i = 0; i < 3; ++i)
        if (const pid_t program = fork(); program == 0)
            _exit(keepsAndFinds(folder) ? 0 : 1);
        else
            programs.push_back(program);
    std::vector<std::thread> threads;
    std::vector<char> right(3, false);
    for (char& each : right)
        threads.emplace_back([&] { each = keepsAndFinds(folder); });
    for (std::thread& thread : threads)
        thread.join();
    for (const pid_t program : programs) {
        int status = 1;
        EXPECT_EQ(waitpid(program, &status, 0), program);
        EXPECT_EQ(status, 0);
    }
    EXPECT_EQ(right, std::vector<char>(3, true));
    for (const files::path& file : entriesOf(place.path()))
        EXPECT_EQ(file.extension(), ".form") << file;
}

TEST(FormFolder, WhereNothingCanBeWrittenNothingIsKept) {
    const TemporaryFolder place;
    const std::string file = place.write("file", "x");
    for (const std::string& path :
         {std::string(), file, file + "/below", std::string("/proc/no"), std::string("/dev/full")}) {
        const FormFolder folder(path, plenty);
        folder.keep("key", "value");
        EXPECT_FALSE(folder.find("key")) << path;
    }
    EXPECT_EQ(bytesOf(file), "x");
}

TEST(FormFolder, OfAFullDiskNothingHalfIsLeft) {
    const TemporaryFolder place;
    const FormFolder folder(place.path(), plenty);
    // In a process of its own, whose files cannot grow any further.
    const pid_t program = fork();
    if (program == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{2000, 2000};
        setrlimit(RLIMIT_FSIZE, &limit);
        folder.keep("large", std::string(100'000, 'x'));
        folder.keep("small", "fits");
        _exit(folder.find("large") || folder.find("small") != "fits" ? 1 : 0);
    }
    int status = 1;
    waitpid(program, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_EQ(entriesOf(place.path()).size(), 1u);
}

} // namespace osgTreeWind
