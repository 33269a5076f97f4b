// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>

/// Makes an interrupted program remove unfinished files (exitOnInterrupt()). Call it before other threads
/// start.
void exitOnSignals();

/// Delays the exit on a signal during its lifetime, so that no row is cut off.
class WholeRow {
public:
    WholeRow();

private:
    std::unique_lock<std::timed_mutex> _lock;
};
