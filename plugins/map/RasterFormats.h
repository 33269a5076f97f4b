// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace osgTreeWind {

/// GDAL's names of the formats of rasters that are opened, ending with null: those that docs/treewind.md
/// names, and those that the environment variable OSGTREEWIND_GDAL_DRIVERS names, parted by commas.
const std::vector<const char*>& rasterFormats();

/// Has GDAL forget all other formats that are of rasters alone: a VRT opens no others. Needs registerGdal().
void forgetOtherRasterFormats();

/// Why a file is not opened; empty: GDAL may try. It is of another format, or a VRT that does more than put
/// files of rasterFormats() together: computes cells, reads raw bytes, or fetches from the net.
std::string problemOfRaster(const std::string& path);

} // namespace osgTreeWind
