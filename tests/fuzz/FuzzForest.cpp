// SPDX-License-Identifier: MIT
#include <tests/fuzz/FuzzForest.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    expectForest(textOf(data, size));
    return 0;
}
