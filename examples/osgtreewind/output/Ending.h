// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/base/WholeFile.h>

#include <string>
#include <utility>

/// How a command ended; the exit status of the program.
enum ExitCode { Succeeded = 0, Failed = 1, BadInput = 2 };

/// Thrown where a command cannot go on: main() says why on standard error.
struct Ending {
    ExitCode exitCode;
    std::string why;
};

/// What was made; where it was not, the end with the first of its problems.
/// @param file to name before that; may be empty.
template <typename T>
T valueOf(osgTreeWind::Result<T> result, ExitCode exitCode = BadInput, const std::string& file = {}) {
    if (!result)
        throw Ending{exitCode, (file.empty() ? "" : file + ": ") + result.problems().front().text()};
    return std::move(result.value());
}

/// The end where a file cannot be written, while it is still there unfinished.
[[noreturn]] inline void endUnwritten(const osgTreeWind::WholeFile& file, const std::string& otherwise = {}) {
    throw Ending{Failed, file.problem(otherwise).text()};
}

/// Writes bytes as a whole file, or ends the command.
inline void writeOrEnd(const std::string& path, const std::string& bytes) {
    if (const osgTreeWind::Diagnostics problems = osgTreeWind::writeWholeFile(path, bytes); !problems.empty())
        throw Ending{Failed, problems.front().text()};
}
