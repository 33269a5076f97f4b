// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>
#include <utility>

namespace osgTreeWind {

/// A problem at a line of a file; line 0 means the file as a whole.
inline Diagnostic fileProblem(const std::string& file, std::string message, int line = 0) {
    return {file, line, 0, {}, std::move(message)};
}

/// A problem with the value of a key or member, without a place in a file.
inline Diagnostic keyProblem(const std::string& key, std::string message) {
    return {{}, 0, 0, key, std::move(message)};
}

} // namespace osgTreeWind
