// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace osgTreeWind {

/// Size of a unit in units of `base`, by UDUNITS; 0 if it is unknown, has another dimension, or is no
/// multiple of `base`.
double sizeByUdunits(const std::string& name, const std::string& base);

} // namespace osgTreeWind
