// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <fstream>
#include <optional>
#include <string>

namespace osgTreeWind {

/// Why a file cannot be read: it does not exist, is not a regular file, or may not be read by this process.
/// Empty if it can be read. Never blocks, not even on a pipe.
std::optional<Diagnostic> problemOfInput(const std::string& path);

/// Opens a regular file for reading in binary mode.
Result<std::ifstream> openInput(const std::string& path);

/// Reads all bytes of a file. An empty file, or one larger than memoryLimit(), is an error.
Result<std::string> readBytes(const std::string& path);
/// Reads all bytes of a file opened by openInput(), from its start.
/// @param path for messages.
Result<std::string> readBytes(std::ifstream& file, const std::string& path);

/// The first bytes of a file, at most `size`. An empty file is an error.
Result<std::string> readHead(const std::string& path, std::size_t size);
/// The next bytes of a file, at most `size`.
std::string readHead(std::istream& file, std::size_t size);

/// Opens a text file and reads it with readText().
Result<std::string> readTextFile(const std::string& path);

} // namespace osgTreeWind
