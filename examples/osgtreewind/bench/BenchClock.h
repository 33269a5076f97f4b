// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

/// Runs from its making on.
class BenchClock {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - _start).count();
    }

private:
    std::chrono::steady_clock::time_point _start = std::chrono::steady_clock::now();
};
