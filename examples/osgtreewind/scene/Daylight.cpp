// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/scene/Daylight.h>

#include <osg/Math>

#include <algorithm>
#include <cmath>

namespace {

/// Illuminance of a clear day by the height of the sun, in klx (IES, Recommended Practice for the Calculation
/// of Daylight Availability, 1984).
struct ClearDay {
    double sine, degrees;

    explicit ClearDay(const osg::Vec3& toSun)
        : sine(std::clamp(static_cast<double>(toSun.z() / toSun.length()), 0.0, 1.0)),
          degrees(osg::RadiansToDegrees(std::asin(sine))) {}

    /// Kasten and Young 1989.
    double airMass() const { return 1.0 / (sine + 0.50572 * std::pow(degrees + 6.07995, -1.6364)); }
    double sky() const { return 0.8 + 15.5 * std::sqrt(sine); }
    double ground() const { return 127.5 * std::exp(-0.21 * airMass()) * sine + sky(); }
};

osg::Vec3 mixed(const osg::Vec3& a, const osg::Vec3& b, float part) {
    return a + (b - a) * part;
}

} // namespace

Daylight::Daylight(const osg::Vec3& direction) : toSun(direction) {
    const ClearDay usual(usualSun), day(direction);
    // An eye, or a camera, makes up for some of what is lost.
    const double exposure = std::pow(usual.ground() / day.ground(), 0.3),
                 more = day.airMass() - usual.airMass();
    const auto through = [&](double opticalDepth) {
        return static_cast<float>(exposure * std::exp(-opticalDepth * more));
    };
    sun = osg::Vec3(1.50f * through(0.13), 1.40f * through(0.21), 1.18f * through(0.33));
    const auto skyLeft = static_cast<float>(exposure * day.sky() / usual.sky());
    sky = osg::Vec3(0.34f, 0.39f, 0.47f) * skyLeft;
    around = osg::Vec3(0.1f, 0.1f, 0.1f) * skyLeft;

    const auto low = static_cast<float>(std::clamp((25.0 - day.degrees) / 25.0, 0.0, 1.0));
    const float written = std::pow(skyLeft, 1.0f / 2.2f);
    zenith = mixed(osg::Vec3(0.29f, 0.49f, 0.79f), osg::Vec3(0.27f, 0.42f, 0.68f), low) * written;
    horizon = mixed(osg::Vec3(0.60f, 0.75f, 0.91f), osg::Vec3(0.74f, 0.77f, 0.82f), low) * written;
    haze = mixed(osg::Vec3(0.80f, 0.87f, 0.93f), osg::Vec3(0.95f, 0.84f, 0.72f), low) * written;
    glow = mixed(osg::Vec3(0.18f, 0.15f, 0.10f), osg::Vec3(0.30f, 0.19f, 0.02f), low);
}
