// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace osgTreeWind {

/// A program that this process has started, and a connection to it. The destructor waits for its end.
class ChildProcess {
public:
    enum class Connection {
        InputAndOutput, ///< Both, in both directions; standard error is discarded. For reader programs.
        Input           ///< Its standard input; it shares standard output and error with this process.
    };
    /// How a process ended.
    struct End {
        bool isSuccess = false;
        std::string
            reason; ///< For messages, after "the program": "timed out", "ended with status 1" and so on.
    };

    ChildProcess() = default;
    ~ChildProcess() { finish(); }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    /// Starts a program, which inherits nothing else from this process. Call it once.
    /// @param program its path; no folders are searched. @return why it cannot be started; empty on success.
    std::string start(const std::string& program, const std::vector<std::string>& arguments,
                      Connection connection);
    /// For readSome() and writeSome(); -1 if the program did not start or has ended.
    int descriptor() const { return _descriptor; }
    /// Closes the connection, which ends a program that reads or writes it, and waits for its end.
    End finish();
    /// Ends the program at once and waits for its end.
    void kill();
    /// Calls kill() for all programs, also while other threads are in functions of these, and lets no other
    /// start. Call it only before this process ends.
    static void killAll();

private:
    std::string startProgram(const std::string& program, const std::vector<std::string>& arguments,
                             Connection connection);
    void awaitEnd(); ///< Closes the connection first.
    End takeEnd();   ///< Releases the process.

    std::intptr_t _process = -1;
    int _descriptor = -1;
};

} // namespace osgTreeWind
