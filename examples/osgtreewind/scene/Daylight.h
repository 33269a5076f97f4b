// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec3>

enum class Weather { Fair, Overcast };

/// Light and sky colours for a position of the sun.
struct Daylight {
    /// Default direction to the sun: south-east, 48 degrees high. Unit length within 0.01 %.
    static inline const osg::Vec3 usualSun{0.45f, -0.5f, 0.74f};

    /// @param toSun direction to the sun, z up; above the horizon.
    explicit Daylight(const osg::Vec3& toSun = usualSun, Weather weather = Weather::Fair);

    osg::Vec3 toSun;
    /// Linear light of the sun on a surface that faces it, of the sky, and of the surroundings.
    osg::Vec3 sun, sky, around;
    /// Display colours: overhead, above the haze, of the haze, and what the sun adds around it.
    osg::Vec3 zenith, horizon, haze, glow;
    osg::Vec3 cloudLight, cloudShade; ///< Display colours of sunlit and shaded clouds.
    float clouds = 0.0f;              ///< Cloud cover, 0 to 1.
    float disc = 1.0f;                ///< Visibility of the sun's disc, 0 to 1.
};
