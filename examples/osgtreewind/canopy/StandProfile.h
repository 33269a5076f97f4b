// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/canopy/StandFlow.h>
#include <osgTreeWind/base/Result.h>

#include <cstdio>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Reads the leaf area density of a stand, relative, from a CSV file with the columns z_over_h and leaf_area.
/// A row is the layer that ends at its height and begins at that of the row before, or at the ground.
/// @return the share of the leaves in each of so many equal layers.
Result<std::vector<float>> readLeafShares(const std::string& path, std::size_t layers);

/// Writes the levels of a flow as CSV.
void writeStandProfile(const StandFlow& flow, double height, std::FILE* out);

} // namespace osgTreeWind
