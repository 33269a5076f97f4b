// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/windfiles/WindFormats.h>

namespace osgTreeWind {

/// The record in the content from a reader.
inline Result<WindSeries> recordOf(const Result<WindContent>& content) {
    if (!content)
        return content.problems();
    return std::get<WindSeries>(content.value().data);
}

} // namespace osgTreeWind
