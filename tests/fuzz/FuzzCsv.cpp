// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

#include <sstream>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    WindSeriesColumns columns;
    columns.time = "time";
    columns.timeUnit = size % 2 ? "s" : "iso8601";
    columns.speed = "speed";
    columns.direction = "direction";
    std::istringstream text{std::string(viewOf(data, size))};
    const Result<WindSeries> series = readWindSeriesCsv(text, "fuzz", columns);
    if (series && series.value().times.size() != series.value().velocities.size())
        std::abort();
    return 0;
}
