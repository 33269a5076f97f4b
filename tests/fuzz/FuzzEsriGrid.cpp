// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Result<RasterBand> grid = readEsriGrid(viewOf(data, size), "fuzz");
    if (grid)
        expectValidContent(windFromBands(grid.value(), grid.value(), "fuzz"));
    return 0;
}
