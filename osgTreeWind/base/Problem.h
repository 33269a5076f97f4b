// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <string>
#include <utility>

namespace osgTreeWind {

/// What is wrong with a file, at a line of it; 0: with the file as a whole.
inline Diagnostic fileProblem(const std::string& file, std::string message, int line = 0) {
    return {file, line, 0, {}, std::move(message)};
}

/// What is wrong with the value of a key or member, wherever it stands.
inline Diagnostic keyProblem(const std::string& key, std::string message) {
    return {{}, 0, 0, key, std::move(message)};
}

} // namespace osgTreeWind
