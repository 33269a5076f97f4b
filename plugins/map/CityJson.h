// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <memory>
#include <string>

namespace osgTreeWind {

/// Whether a file says so.
bool isCityJson(const std::string& path);

/// Its SolitaryVegetationObjects as features of one layer: points at their feet, with their attributes and
/// their `id`. @return a GDALDatasetH.
Result<std::shared_ptr<void>> readCityJson(const std::string& path);

} // namespace osgTreeWind
