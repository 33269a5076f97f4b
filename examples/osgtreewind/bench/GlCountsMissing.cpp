// SPDX-License-Identifier: MIT
// In place of GlCounts.cpp on Windows, where a program cannot replace functions that DLLs call.
#include <examples/osgtreewind/bench/GlCounts.h>

#include <numeric>
#include <stdexcept>

void DrawWork::add(const DrawWork& other) {
    draws += other.draws;
    for (std::size_t i = 0; i < counts.size(); ++i)
        counts[i] += other.counts[i];
}

std::uint64_t GlCounts::allCalls() const {
    return std::accumulate(calls.begin(), calls.end(), std::uint64_t(0));
}

GlCounts countGlCalls(const std::function<void()>&, bool) {
    throw std::runtime_error("the OpenGL calls of a program cannot be counted on Windows");
}
