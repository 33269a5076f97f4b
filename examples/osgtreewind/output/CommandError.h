// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/Result.h>

#include <algorithm>
#include <string>
#include <utility>

/// Exit status of the program.
enum ExitCode { Succeeded = 0, Failed = 1, BadInput = 2 };

/// Thrown by a command that cannot go on; main() prints the message to standard error.
struct CommandError {
    ExitCode exitCode;
    std::string message;
};

/// Throws CommandError with up to 100 of the problems, one per line, and the number of the others: a world
/// may lack a million tiles.
/// @param file prefix of the message; may be empty.
[[noreturn]] inline void throwProblems(osgTreeWind::Diagnostics problems, ExitCode exitCode = BadInput,
                                       const std::string& file = {}) {
    const std::size_t count = problems.size(), printed = std::min<std::size_t>(count, 100);
    problems.resize(printed);
    throw CommandError{exitCode,
                       (file.empty() ? "" : file + ": ") + toString(problems) +
                           (count > printed ? "\nand " + std::to_string(count - printed) + " more problems"
                                            : std::string())};
}

/// throwProblems() if there are any.
inline void throwIfAny(const osgTreeWind::Diagnostics& problems, ExitCode exitCode = BadInput) {
    if (!problems.empty())
        throwProblems(problems, exitCode);
}

/// The value of a result, or else throwProblems().
template <typename T>
T valueOrThrow(osgTreeWind::Result<T> result, ExitCode exitCode = BadInput, const std::string& file = {}) {
    if (!result)
        throwProblems(result.problems(), exitCode, file);
    return std::move(result.value());
}

/// Throws CommandError for a file that cannot be written. Call it while the unfinished file still exists.
[[noreturn]] inline void throwWriteError(const osgTreeWind::AtomicFile& file,
                                         const std::string& fallback = {}) {
    throw CommandError{Failed, file.problem(fallback).text()};
}

/// Writes a complete file. Throws CommandError on failure.
inline void writeOrThrow(const std::string& path, const std::string& bytes) {
    throwIfAny(osgTreeWind::writeFileAtomically(path, bytes), Failed);
}
