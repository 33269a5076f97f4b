// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/scene/Setting.h>

namespace CLI {
class App;
}

struct LightOptions {
    osg::Vec3 toSun = Daylight::usualSun; ///< Unit vector; x east, y north, z up.
    Weather weather = Weather::Fair;
    std::optional<bool> shadows; ///< By default on, but off in worlds.

    Daylight day() const { return Daylight(toSun, weather); }
};

/// Adds --sun, --sky and --shadows. The value of --sun is "AZIMUTH,ELEVATION" in degrees or
/// "TIME@LATITUDE,LONGITUDE"; the sun must be above the horizon.
void addLightOptions(CLI::App& command, LightOptions& options);
