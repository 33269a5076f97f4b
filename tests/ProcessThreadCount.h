// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <iterator>

/// Current number of threads of this process.
inline std::ptrdiff_t processThreadCount() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"),
                         std::filesystem::directory_iterator());
}
