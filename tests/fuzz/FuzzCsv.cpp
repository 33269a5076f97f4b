// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    WindSeriesColumns columns;
    columns.time = "time";
    columns.timeUnit = size % 2 ? "s" : "iso8601";
    columns.speed = "speed";
    columns.direction = "direction";
    expectValidContent(readWindCsv(viewOf(data, size), "fuzz", columns));
    return 0;
}
