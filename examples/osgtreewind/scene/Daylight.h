// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Vec3>

enum class Weather { Fair, Overcast };

/// The light of a day by where the sun stands, and the colours of its sky.
struct Daylight {
    /// Where the sun stands if nobody says: in the south-east, half way up. Toward it, unit length to 0.01 %.
    static inline const osg::Vec3 usualSun{0.45f, -0.5f, 0.74f};

    /// @param toSun toward the sun, z up; above the horizon.
    explicit Daylight(const osg::Vec3& toSun = usualSun, Weather weather = Weather::Fair);

    osg::Vec3 toSun;
    /// Light of the sun on what faces it, of the sky, and of all that stands around; linear.
    osg::Vec3 sun, sky, around;
    /// Colours, as they are written, of the sky overhead, of it above the haze, of the haze, and of what the
    /// sun adds around it.
    osg::Vec3 zenith, horizon, haze, glow;
    osg::Vec3 cloudLight, cloudShade; ///< Likewise, of clouds where the sun meets them and where it does not.
    float clouds = 0.0f;              ///< How far they cover the sky, 0 to 1.
    float disc = 1.0f;                ///< How much of the sun itself is seen, 0 to 1.
};
