// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/windfiles/WindFormats.h>

#include <cstdint>
#include <cstdlib>

/// Entry point that libFuzzer calls; see script/fuzz.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace osgTreeWind {

inline std::string_view viewOf(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Aborts unless the result is an error with a message, a grid with a value for each point, or a series with
/// a velocity for each time.
inline void expectValidContent(const Result<WindContent>& content) {
    if (!content) {
        if (content.problems().empty() || content.problems().front().message.empty())
            std::abort();
        return;
    }
    if (const auto* series = std::get_if<WindSeries>(&content.value().data))
        if (series->times.size() != series->velocities.size())
            std::abort();
    if (const auto* grid = std::get_if<GridWind::Grid>(&content.value().data)) {
        const double steps = grid->times.empty() ? 1.0 : static_cast<double>(grid->times.size());
        if (3.0 * grid->points.x * grid->points.y * grid->points.z * steps !=
            static_cast<double>(grid->values.size()))
            std::abort();
    }
}

} // namespace osgTreeWind
