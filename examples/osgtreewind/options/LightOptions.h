// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/Setting.h>

namespace CLI {
class App;
}

/// Adds --sun: "AZIMUTH,ELEVATION" in degrees, clockwise from north, or "TIME@LATITUDE,LONGITUDE", above the
/// horizon.
/// @param toSun of unit length, x east, y north and z up.
void addSunOption(CLI::App& command, osg::Vec3& toSun);

/// Adds --shadows.
void addShadowsOption(CLI::App& command, Shadows& shadows);
