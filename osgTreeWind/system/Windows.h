// SPDX-License-Identifier: MIT
#pragma once

// For the implementations of this module on Windows only.

#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>

#include <string>
#include <string_view>
#include <system_error>

namespace osgTreeWind {

/// Status of a program that limitTime() or limitMemory() ends.
constexpr unsigned timeIsUpStatus = 142, memoryIsUpStatus = 137; // as shells report SIGALRM and SIGKILL

std::wstring toWide(std::string_view utf8);
std::string toUtf8(std::wstring_view wide);

/// The absolute path of an open file or folder, without links and without the prefix of long paths. Empty if
/// Windows knows no path.
std::wstring pathOfFile(HANDLE file);

/// What an error of GetLastError() means.
std::string messageOf(unsigned long error);

} // namespace osgTreeWind
