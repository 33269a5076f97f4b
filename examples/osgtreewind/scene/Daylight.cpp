// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Daylight.h>

#include <osgTreeWind/base/PortableMath.h>

#include <examples/osgtreewind/scene/Mix.h>

#include <osg/Math>

#include <algorithm>
#include <cmath>

namespace math = osgTreeWind::math;

namespace {

/// Illuminance on a clear day for an elevation of the sun, klx (IES, Recommended Practice for the Calculation
/// of Daylight Availability, 1984).
struct ClearDay {
    double sine, degrees;

    explicit ClearDay(const osg::Vec3& toSun)
        : sine(std::clamp(static_cast<double>(toSun.z() / toSun.length()), 0.0, 1.0)),
          degrees(osg::RadiansToDegrees(math::asin(sine))) {}

    /// Kasten and Young 1989.
    double airMass() const { return 1.0 / (sine + 0.50572 * math::pow(degrees + 6.07995, -1.6364)); }
    double sky() const { return 0.8 + 15.5 * std::sqrt(sine); }
    double ground() const { return 127.5 * math::exp(-0.21 * airMass()) * sine + sky(); }
};

} // namespace

Daylight::Daylight(const osg::Vec3& direction, Weather weather) : toSun(direction) {
    const ClearDay usual(usualSun), day(direction);
    // The eye partly adapts to dimmer light.
    const double exposure = math::pow(usual.ground() / day.ground(), 0.3),
                 more = day.airMass() - usual.airMass();
    const auto transmitted = [&](double opticalDepth) {
        return static_cast<float>(exposure * math::exp(-opticalDepth * more));
    };
    const auto skyLeft = static_cast<float>(exposure * day.sky() / usual.sky());
    const float display = math::pow(skyLeft, 1.0f / 2.2f);
    if (weather == Weather::Overcast) {
        sun = osg::Vec3(0.06f, 0.06f, 0.06f) * transmitted(0.2);
        sky = osg::Vec3(0.88f, 0.85f, 0.80f) * skyLeft; // shaders/light.glsl makes it bluer from above
        around = osg::Vec3(0.10f, 0.10f, 0.10f) * skyLeft;
        zenith = osg::Vec3(0.80f, 0.82f, 0.85f) * display;
        horizon = osg::Vec3(0.72f, 0.75f, 0.78f) * display;
        haze = osg::Vec3(0.76f, 0.79f, 0.81f) * display;
        cloudLight = osg::Vec3(0.88f, 0.89f, 0.91f) * display;
        cloudShade = osg::Vec3(0.62f, 0.65f, 0.69f) * display;
        clouds = 1.0f;
        disc = 0.0f;
        return;
    }
    sun = osg::Vec3(2.02f * transmitted(0.13), 1.88f * transmitted(0.21), 1.60f * transmitted(0.33));
    sky = osg::Vec3(0.26f, 0.31f, 0.40f) * skyLeft;
    around = osg::Vec3(0.06f, 0.06f, 0.05f) * skyLeft;

    const auto low = static_cast<float>(std::clamp((25.0 - day.degrees) / 25.0, 0.0, 1.0));
    zenith = mix(osg::Vec3(0.24f, 0.44f, 0.74f), osg::Vec3(0.27f, 0.42f, 0.66f), low) * display;
    horizon = mix(osg::Vec3(0.60f, 0.75f, 0.90f), osg::Vec3(0.78f, 0.78f, 0.80f), low) * display;
    haze = mix(osg::Vec3(0.78f, 0.85f, 0.91f), osg::Vec3(0.95f, 0.84f, 0.72f), low) * display;
    glow = mix(osg::Vec3(0.18f, 0.15f, 0.10f), osg::Vec3(0.34f, 0.21f, 0.04f), low);
    cloudLight = mix(osg::Vec3(0.98f, 0.98f, 0.98f), osg::Vec3(1.0f, 0.90f, 0.78f), low) * display;
    cloudShade = mix(osg::Vec3(0.64f, 0.69f, 0.77f), osg::Vec3(0.60f, 0.58f, 0.64f), low) * display;
    clouds = 0.50f;
}
