// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/Setting.h>

namespace CLI {
class App;
}

struct LightOptions {
    osg::Vec3 toSun = Daylight::usualSun; ///< Of unit length, x east, y north and z up.
    Weather weather = Weather::Fair;
    Shadows shadows = Shadows::Soft;

    Daylight day() const { return Daylight(toSun, weather); }
};

/// Adds --sun: "AZIMUTH,ELEVATION" in degrees, clockwise from north, or "TIME@LATITUDE,LONGITUDE", above the
/// horizon; --sky and --shadows.
void addLightOptions(CLI::App& command, LightOptions& options);
