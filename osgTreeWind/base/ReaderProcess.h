// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/system/ChildProcess.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A program that reads a file format in a separate process, so that a damaged file cannot crash the host
/// through a third-party library.
struct ReaderProgram {
    const char* name;     ///< File name, in osgTreeWind/ beside the library.
    const char* variable; ///< Environment variable that overrides the program's path.
    const char* format;   ///< Format name for messages.
    const char* library;  ///< Library that the program needs at build time, for messages.
};

/// A running reader program with a two-way connection. The destructor ends the process.
class ReaderProcess {
public:
    /// Starts the program.
    ReaderProcess(const ReaderProgram& reader, const std::vector<std::string>& arguments);

    /// The connection to the program's standard input and output; -1 if it did not start or has ended.
    int descriptor() const { return _program.descriptor(); }
    bool started() const { return _startProblem.empty(); }
    /// Why the program did not answer. Ends the process if it still runs.
    std::string problem();

private:
    ChildProcess _program;
    std::string _startProblem, _endProblem;
};

/// Reads a file with a reader program. Thread-safe.
/// @param arguments of the program; the first is the file's path.
template <typename T>
Result<T> readWithProgram(const ReaderProgram& reader, const std::vector<std::string>& arguments) {
    if (const auto problem = problemOfInput(arguments.front()))
        return *problem;
    ReaderProcess process(reader, arguments);
    auto answer = process.started() ? Wire::receive<T>(process.descriptor()) : std::nullopt;
    if (answer)
        return std::move(*answer);
    const std::string prefix =
        process.started() ? std::string("the ") + reader.format + " file is damaged: " : "";
    return fileProblem(arguments.front(), prefix + process.problem());
}

} // namespace osgTreeWind
