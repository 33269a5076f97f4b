// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    expectValidContent(readTurbSim(viewOf(data, size), "fuzz"));
    return 0;
}
