// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

#include <osgTreeWind/windfiles/QesSensor.h>

#include <sstream>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream text{std::string(viewOf(data, size))};
    const Result<WindSeries> series = readQesSensor(text, "fuzz");
    if (series && series.value().times.size() != series.value().velocities.size())
        std::abort();
    return 0;
}
