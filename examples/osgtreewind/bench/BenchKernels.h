// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

/// What one branch, one tree, one leaf or one sample of the wind costs, without graphics.
struct BenchKernel {
    std::string group;               ///< "laws" or "winds".
    std::string name;                ///< "thesis", "gusts", ...
    std::string element;             ///< What is counted: "branch", "tree", "leaf" or "sample".
    std::size_t elements = 0;        ///< In a round.
    std::vector<double> nanoseconds; ///< An element, a number a round.
    unsigned threads = 1;
};

/// A kernel before it is measured.
struct TimedKernel {
    BenchKernel kernel;
    std::function<void(double)> round; ///< Given the time of the round, seconds.
};

/// From one step to the next, seconds.
constexpr float kernelStep = 1.0f / 60.0f;

/// Takes results, so that the work is not optimized away.
inline volatile float kernelResult = 0.0f;

/// Measures the groups asked for, all kernels in turns in each round, so that what else the machine does
/// falls on all of them. @param groups "laws", "winds" or both. @param rounds 1 or more.
std::vector<BenchKernel> runBenchKernels(const std::vector<std::string>& groups, int rounds);
