// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/wind/WindSeries.h>

#include <istream>
#include <string>

namespace osgTreeWind {

/// Reads a wind record from a QES-Winds sensor file: XML, with or without a single root, whose `timeSeries`
/// elements each hold timeEpoch (s), height and siteZ0 (m), speed (m/s) and direction (degrees from).
/// Times become seconds since the first; height and roughness become the profile.
///
/// Problems carry line and column: broken XML, a missing or repeated element, text in a number, values no
/// wind has, times that do not increase. Only the neutral logarithmic profile is read (boundaryLayerFlag 1
/// and reciprocal 0, both the defaults when absent), with one height and roughness for the whole record.
/// @param file name for diagnostics only.
Result<WindSeries> readQesSensor(std::istream& input, const std::string& file);

} // namespace osgTreeWind
