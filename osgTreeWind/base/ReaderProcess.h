// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Wire.h>

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace osgTreeWind {

/// A program that reads a format in a process of its own: a damaged file, on which the library behind it may
/// break, ends that process and not the one that has a forest.
struct ReaderProgram {
    const char* name;     ///< It stands in osgTreeWind/ beside the library,
    const char* variable; ///< or where this variable of the environment says.
    const char* format;   ///< For people.
    const char* library;  ///< What had to be there when it was built.
};

/// A reader program while it runs, with a way to it and back. It ends when this is destroyed.
class ReaderProcess {
public:
    /// Starts it. @param command its arguments.
    ReaderProcess(const ReaderProgram& reader, const std::vector<std::string>& command);
    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;
    ~ReaderProcess();

    /// Its standard input and output; -1 where it was not started or has ended.
    int descriptor() const { return _descriptor; }
    bool started() const { return _startProblem.empty(); }
    /// Why it gives no answer. Ends it, if it has not ended by itself.
    std::string problem();

private:
    void close();

    std::string _startProblem, _end;
    pid_t _process = -1;
    int _descriptor = -1;
};

/// What a program answers of a file. Any thread may ask.
/// @param command its arguments, of which the file is the first.
template <typename T>
Result<T> readBy(const ReaderProgram& reader, const std::vector<std::string>& command) {
    if (const auto problem = problemOfInput(command.front()))
        return *problem;
    ReaderProcess process(reader, command);
    auto answer = process.started() ? Wire::receive<T>(process.descriptor()) : std::nullopt;
    if (answer)
        return std::move(*answer);
    const std::string what =
        process.started() ? std::string("the ") + reader.format + " file is damaged: " : "";
    return fileProblem(command.front(), what + process.problem());
}

} // namespace osgTreeWind
