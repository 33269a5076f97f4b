// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <algorithm>

namespace osgTreeWind {

/// How many shapes trees of a species have, in range; a tree's seed modulo that is its own.
inline std::uint32_t shapeCount(const Species& species) {
    return static_cast<std::uint32_t>(std::clamp(species.shapes, 1, mostShapes));
}

} // namespace osgTreeWind
