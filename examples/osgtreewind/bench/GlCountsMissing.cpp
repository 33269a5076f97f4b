// SPDX-License-Identifier: MIT
// In place of GlCounts.cpp on Windows, where a program cannot replace functions that DLLs call.
#include <examples/osgtreewind/bench/GlCounts.h>

#include <stdexcept>

GlCounts countGlCalls(const std::function<void()>&, bool) {
    throw std::runtime_error("the OpenGL calls of a program cannot be counted on Windows");
}
