// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>

/// Makes SIGINT and SIGTERM remove unfinished files and exit with 128 + the signal number. Call it before
/// other threads start.
void exitOnSignals();

/// Delays the exit on a signal during its lifetime, so that no row is cut off.
class WholeRow {
public:
    WholeRow();

private:
    std::unique_lock<std::mutex> _lock;
};
