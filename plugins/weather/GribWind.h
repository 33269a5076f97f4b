// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/windfiles/WindContent.h>
#include <osgTreeWind/windfiles/WindRequest.h>

#include <string>

namespace osgTreeWind {

/// Reads the wind of a GRIB file, edition 1 or 2, in longitude and latitude or the file's own projection.
/// Velocities relative to true north are turned to the y axis of the projection, unless WindRequest::asStored
/// is set.
Result<WindContent> readGribWind(const std::string& path, const WindRequest& request);

} // namespace osgTreeWind
