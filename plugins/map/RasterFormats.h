// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// GDAL's names of the supported raster formats, with a final null: those of docs/treewind.md, and those of
/// the environment variable OSGTREEWIND_GDAL_DRIVERS, separated by commas.
const std::vector<const char*>& rasterFormats();

/// Deregisters GDAL's other drivers for rasters only, so that a VRT cannot use them. Needs registerGdal().
void deregisterOtherRasterDrivers();

/// Why a file must not be opened; empty if GDAL may try. Rejects other formats, and VRTs that do more than
/// combine files of rasterFormats(): those that compute cells, read raw bytes or use the network.
std::string problemOfRaster(const std::string& path);

} // namespace osgTreeWind
