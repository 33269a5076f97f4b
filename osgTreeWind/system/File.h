// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace osgTreeWind {

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePointer = std::unique_ptr<std::FILE, CloseFile>;

/// As std::fopen(), with any name. @param path UTF-8. @return null on failure.
FilePointer openFile(const std::string& path, const char* mode);
/// Opens a new file in a folder for reading and writing, which vanishes when it is closed or the process
/// ends.
/// @return null on failure.
FilePointer openVanishingFile(const std::string& folder);
/// Moves to a place in a file, also beyond 2 GB. @return whether that succeeded.
bool seekFile(std::FILE* file, std::int64_t offset);

/// Removes a file or folder, with its contents, even while this process writes into it. Call it only before
/// the process exits: on Windows it closes these files.
void removeUnfinished(const std::string& path);

/// Whether this process may create files in a folder.
bool mayWriteInto(const std::string& folder);
/// Whether a program holds a file open in a way that keeps it from being replaced; never on Linux.
bool isHeldOpen(const std::string& path);

} // namespace osgTreeWind
