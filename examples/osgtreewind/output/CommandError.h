// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/Result.h>

#include <string>
#include <utility>

/// Exit status of the program.
enum ExitCode { Succeeded = 0, Failed = 1, BadInput = 2 };

/// Thrown by a command that cannot go on; main() prints the message to standard error.
struct CommandError {
    ExitCode exitCode;
    std::string message;
};

/// The value of a result. Throws CommandError with the first problem if it has no value.
/// @param file prefix of the message; may be empty.
template <typename T>
T valueOrThrow(osgTreeWind::Result<T> result, ExitCode exitCode = BadInput, const std::string& file = {}) {
    if (!result)
        throw CommandError{exitCode, (file.empty() ? "" : file + ": ") + result.problems().front().text()};
    return std::move(result.value());
}

/// Throws CommandError for a file that cannot be written. Call it while the unfinished file still exists.
[[noreturn]] inline void throwWriteError(const osgTreeWind::AtomicFile& file,
                                         const std::string& fallback = {}) {
    throw CommandError{Failed, file.problem(fallback).text()};
}

/// Writes a complete file. Throws CommandError on failure.
inline void writeOrThrow(const std::string& path, const std::string& bytes) {
    if (const osgTreeWind::Diagnostics problems = osgTreeWind::writeFileAtomically(path, bytes);
        !problems.empty())
        throw CommandError{Failed, problems.front().text()};
}
