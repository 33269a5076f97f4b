// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/ReaderProgram.h>

#include <sys/types.h>

namespace osgTreeWind {

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

    const ReaderProgram _reader;
    std::string _startProblem, _end;
    pid_t _process = -1;
    int _descriptor = -1;
};

} // namespace osgTreeWind
