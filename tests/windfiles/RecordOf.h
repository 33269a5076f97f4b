// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/windfiles/WindFormats.h>

namespace osgTreeWind {

/// The record that a reader of one gives, in place of all that it says of it.
inline Result<WindSeries> recordOf(const Result<WindContent>& content) {
    if (!content)
        return content.problems();
    return std::get<WindSeries>(content.value().data);
}

} // namespace osgTreeWind
