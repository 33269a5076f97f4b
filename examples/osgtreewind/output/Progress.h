// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

/// Progress bar on standard error, shown after one second if standard error is a terminal.
class Progress {
public:
    Progress(std::string what, std::size_t total);
    ~Progress();
    void advance();

private:
    using Clock = std::chrono::steady_clock;

    std::string _what;
    std::size_t _total, _done = 0;
    Clock::time_point _start = Clock::now(), _shown = _start;
    bool _terminal, _visible = false;
};
