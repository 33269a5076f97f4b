// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/species/Species.h>

#include <algorithm>

namespace osgTreeWind {

/// Number of shapes of a species, clamped to its range. A tree has the shape of its seed modulo this number.
inline std::uint32_t shapeCount(const Species& species) {
    return static_cast<std::uint32_t>(std::clamp(species.shapes, 1, maxShapes));
}

} // namespace osgTreeWind
