// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchKernels.h>

/// One step of whole reference trees (122 units) under `damped` and under `modal`, leaves not counted.
/// Each law calm and in gusts that it samples itself: `damped` at its 122 units, `modal` at its 10 patches;
/// `modal` also on all cores, and by itself with every instruction set that this machine has.
std::vector<TimedKernel> treeKernels();
