// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>
#include <string_view>

/// Number of cases of a long test: all if OSGTREEWIND_TESTS is `full`, as in script/check, otherwise a
/// sample.
inline int casesToRun(int all, int sample) {
    const char* const wanted = std::getenv("OSGTREEWIND_TESTS");
    return wanted && std::string_view(wanted) == "full" ? all : sample;
}
