// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec3>

#include <string>

/// Toward the sun, unit length, x east, y north and z up, of a text: "AZIMUTH,ELEVATION" in degrees,
/// clockwise from north, or "TIME@LATITUDE,LONGITUDE". Throws CLI::ValidationError for option --sun, also
/// where the sun is not above the horizon.
osg::Vec3 parseSun(const std::string& text);
