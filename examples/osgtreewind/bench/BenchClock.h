// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>

/// Clock that starts when it is created.
class BenchClock {
public:
    double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - _start).count();
    }

private:
    std::chrono::steady_clock::time_point _start = std::chrono::steady_clock::now();
};
