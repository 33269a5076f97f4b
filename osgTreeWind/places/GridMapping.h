// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/Crs.h>

#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// A CRS as attributes of a grid_mapping variable (CF conventions 1.8, appendix F).
struct GridMapping {
    std::string name; ///< grid_mapping_name; empty for a projection that is not supported here.
    using Numbers = std::pair<std::string, std::vector<double>>;
    std::vector<Numbers> numbers;
    std::string wkt; ///< crs_wkt; always valid.

    auto parts() { return std::tie(name, numbers, wkt); } ///< For Wire.
};

Result<GridMapping> gridMappingOf(const Crs& map);

} // namespace osgTreeWind
