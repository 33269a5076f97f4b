// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <filesystem>
#include <initializer_list>
#include <string>
#include <vector>

#include <unistd.h>

namespace osgTreeWind {

/// A reader of untrusted bytes.
struct FuzzReader {
    const char* name;
    void (*read)(const std::string& bytes); ///< Calls require() for what the reader answers.
};

/// The readers of the program.
inline std::vector<FuzzReader>& fuzzReaders() {
    static std::vector<FuzzReader> readers;
    return readers;
}

/// Adds readers to the program.
struct FuzzReaders {
    FuzzReaders(std::initializer_list<FuzzReader> readers) {
        fuzzReaders().insert(fuzzReaders().end(), readers.begin(), readers.end());
    }
};

/// Ends the program with SIGILL, which libraries do not raise, unless `condition` holds.
inline void require(bool condition) {
    if (!condition)
        __builtin_trap();
}

/// Whether reading gave a value; otherwise it must have given a message.
template <typename T>
bool isRead(const Result<T>& result) {
    require(result || (!result.problems().empty() && !result.problems().front().message.empty()));
    return static_cast<bool>(result);
}

/// A file of this process, for readers that open one.
inline const std::string& fuzzFile() {
    static const struct File {
        std::string path =
            (std::filesystem::temp_directory_path() / ("fuzz" + std::to_string(getpid()) + ".csv")).string();
        ~File() { std::filesystem::remove(path); }
    } file;
    return file.path;
}

} // namespace osgTreeWind
