// SPDX-License-Identifier: MIT
#include <tests/fuzz/Fuzz.h>

#include <plugins/weather/GribChoice.h>

#include <cmath>

using namespace osgTreeWind;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto fields = readGribFields(viewOf(data, size), "fuzz");
    if (!fields) {
        if (fields.problems().front().message.empty())
            std::abort();
        return 0;
    }
    for (const GribField& field : fields.value())
        if (field.parts.empty() || !std::isfinite(field.valid) || !std::isfinite(field.level.value))
            std::abort();
    const auto choice = chooseGribWind(fields.value(), "fuzz");
    if (!choice)
        return 0;
    const std::size_t count = choice.value().times.size() * choice.value().levels.size();
    if (count == 0 || choice.value().east.size() != count || choice.value().north.size() != count)
        std::abort();
    for (const GribField* field : choice.value().allFields())
        if (!field)
            std::abort();
    return 0;
}
