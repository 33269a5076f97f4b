// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <fstream>
#include <optional>
#include <string>

namespace osgTreeWind {

/// Why a file cannot be read: nothing is there, or what is there is a folder, a pipe, a socket or a device,
/// or this program may not read it. Never blocks, not even on a pipe.
std::optional<Diagnostic> problemOfInput(const std::string& path);

/// A regular file, open for reading bytes, or why it cannot be read.
Result<std::ifstream> openInput(const std::string& path);

/// Reads all bytes of a file. A file that is empty, that cannot be read or that is larger than memoryLimit()
/// is a problem.
Result<std::string> readBytes(const std::string& path);
/// Reads all bytes of a file that openInput() opened, however far it was read before.
/// @param path for messages.
Result<std::string> readBytes(std::ifstream& file, const std::string& path);

/// All of a text file as readText() gives it, or why it cannot be read.
Result<std::string> readTextFile(const std::string& path);

} // namespace osgTreeWind
