// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindRequest.h>

#include <string>

namespace osgTreeWind {

/// Wind of a file of GRIB, edition 1 or 2, on longitudes and latitudes or on the file's own map. What counts
/// from true north is turned to the y axis of the map, unless wanted as stored.
Result<WindContent> readGribWind(const std::string& path, const WindRequest& request);

} // namespace osgTreeWind
