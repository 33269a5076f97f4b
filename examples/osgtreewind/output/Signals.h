// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>

/// From now on SIGINT and SIGTERM remove what is unfinished and end the program with 128 and their number.
/// Call it before there are other threads.
void endOnSignals();

/// While it lives no signal ends the program: a row that is printed is whole.
class WholeRow {
public:
    WholeRow();

private:
    std::unique_lock<std::mutex> _lock;
};
