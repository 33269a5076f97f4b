// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchKernels.h>

/// One step of whole reference trees (122 units) under `modal`, leaves not counted: calm, and in gusts that
/// it samples itself at its 10 patches; also on all cores, and by itself with every instruction set that this
/// machine has.
std::vector<TimedKernel> treeKernels();
