// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace osgTreeWind {

/// The path that a text names. Texts are UTF-8; Linux keeps bytes that are not, and Windows takes U+FFFD in
/// their place.
std::filesystem::path toPath(const std::string& text);
/// The text of a path, with / between folders.
std::string toText(const std::filesystem::path& path);

/// Parts of a path: its folder, empty if it names none; its extension with the dot; its name without that.
std::string folderOf(const std::string& path);
std::string extensionOf(const std::string& path);
std::string stemOf(const std::string& path);
/// The path from the root of the file system.
std::string absolutePath(const std::string& path);
/// A path that is relative to a folder or absolute, without `.` and `..` where possible.
std::string pathIn(const std::string& folder, const std::string& path);

/// The path of an existing file or folder without links, `..`, short names and wrong cases; empty if there is
/// none.
std::filesystem::path resolved(const std::filesystem::path& path);

/// Whether a path is a link to a file or folder.
bool isLink(const std::string& path);

/// Why a text cannot name an ordinary file, judged without opening anything; empty if it can. Windows has
/// devices such as NUL and COM1, streams such as `a.csv:b`, and paths such as `C:x` that depend on hidden
/// folders.
std::string problemOfName(const std::string& text);
/// Whether a text is a path to another machine or one that Windows takes literally, `\\server\share` or
/// `\\?\`. Opening the first sends the user's name to that machine. Never on Linux.
bool leavesTheMachine(const std::string& text);

} // namespace osgTreeWind
