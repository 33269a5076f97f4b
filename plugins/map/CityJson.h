// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <memory>
#include <string>

namespace osgTreeWind {

/// Whether a file is CityJSON, by its content.
bool isCityJson(const std::string& path);

/// Reads the SolitaryVegetationObjects as point features of one layer, at the feet of the trees, with their
/// attributes and `id`. @return a GDALDatasetH.
Result<std::shared_ptr<void>> readCityJson(const std::string& path);

} // namespace osgTreeWind
