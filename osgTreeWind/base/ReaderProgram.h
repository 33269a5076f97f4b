// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A program that reads a format in a process of its own: a damaged file, on which the library behind it may
/// break, ends that process and not the one that has a forest.
struct ReaderProgram {
    const char* name;     ///< It stands in osgTreeWind/ beside the library,
    const char* variable; ///< or where this variable of the environment says.
    const char* format;   ///< For people.
    const char* library;  ///< What had to be there when it was built.
};

/// Runs it for a file. Any thread may.
/// @param wanted its arguments after the file.
/// @param receive takes the answer from a file descriptor; false where it ends too early or makes no sense.
/// @return why there is no answer.
std::optional<Diagnostic> runReader(const ReaderProgram& reader, const std::string& path,
                                    const std::vector<std::string>& wanted,
                                    const std::function<bool(int)>& receive);

} // namespace osgTreeWind
