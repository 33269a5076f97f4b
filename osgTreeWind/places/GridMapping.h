// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// A map in the words of the CF conventions (1.8, appendix F): the attributes of a grid_mapping.
struct GridMapping {
    std::string name; ///< grid_mapping_name; empty for a projection whose words are not known here.
    using Numbers = std::pair<std::string, std::vector<double>>;
    std::vector<Numbers> numbers;
    std::string wkt; ///< crs_wkt, which always holds.

    auto parts() { return std::tie(name, numbers, wkt); } ///< For Wire.
};

Result<GridMapping> gridMappingOf(const Crs& map);

} // namespace osgTreeWind
