// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <iterator>

/// How many threads this program has now.
inline std::ptrdiff_t threadsOfTheProcess() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"),
                         std::filesystem::directory_iterator());
}
