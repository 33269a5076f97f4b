// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzScan.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    expectErrorOrTrees(readTreeQsm({reinterpret_cast<const char*>(data), size}, "fuzz"));
    return 0;
}
