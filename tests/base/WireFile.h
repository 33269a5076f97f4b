// SPDX-License-Identifier: MIT
#pragma once

#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>

#include <fcntl.h>
#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

/// A file in place of the connection to a reader program (base/Wire.h).
class WireFile {
public:
    WireFile() = default;
    ~WireFile() { ::close(_descriptor); }
    WireFile(const WireFile&) = delete;
    WireFile& operator=(const WireFile&) = delete;

    int descriptor() const { return _descriptor; }
    std::int64_t length() const { return ::lseek(_descriptor, 0, SEEK_CUR); }
    void rewind() { ::lseek(_descriptor, 0, SEEK_SET); }
    void truncate(std::int64_t length) {
#ifdef _WIN32
        EXPECT_EQ(_chsize_s(_descriptor, length), 0);
#else
        EXPECT_EQ(::ftruncate(_descriptor, static_cast<off_t>(length)), 0);
#endif
    }
    /// Overwrites the byte at an offset.
    void overwrite(std::int64_t at, char byte) {
        ::lseek(_descriptor, static_cast<off_t>(at), SEEK_SET);
        EXPECT_EQ(::write(_descriptor, &byte, 1), 1);
    }

private:
#ifdef _WIN32
    static constexpr int binary = O_BINARY;
#else
    static constexpr int binary = 0;
#endif
    TemporaryFolder _folder;
    int _descriptor = ::open((_folder.path() + "/wire").c_str(), O_RDWR | O_CREAT | binary, 0600);
};
