// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyProfile.h>
#include <osgTreeWind/wind/SwingingWind.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// Raupach 1994: d/h, z0/h and u*/U(h). The sign of 0.193 makes U(h) exceed the logarithmic law, as follows
/// from the constant slope in the sublayer.
struct Raupach {
    double displacement, roughness, friction;
    explicit Raupach(double area) {
        const double x = std::sqrt(7.5 * 2.0 * area);
        displacement = 1.0 - (1.0 - std::exp(-x)) / x;
        friction = std::min(std::sqrt(0.003 + 0.3 * area), 0.3);
        roughness = (1.0 - displacement) * std::exp(-0.4 / friction + 0.193);
    }
};

TEST(CanopyProfile, IsRaupachsLogarithmicLawAboveTheSublayer) {
    for (const double area : {0.05, 0.2, 1.0, 2.5}) {
        const CanopyProfile profile = CanopyProfile::ofStand(20.0f, static_cast<float>(area));
        const Raupach raupach(area);
        EXPECT_NEAR(static_cast<double>(profile.displacement()), raupach.displacement, 1e-4);
        EXPECT_NEAR(static_cast<double>(profile.friction), raupach.friction, 1e-4);
        for (const double z : {40.0, 60.0, 200.0})
            EXPECT_NEAR(static_cast<double>(profile.mean(static_cast<float>(z))) /
                            (raupach.friction / 0.4 *
                             std::log((z / 20.0 - raupach.displacement) / raupach.roughness)),
                        1.0, 0.01)
                << area << " at " << z;
    }
}

TEST(CanopyProfile, IsCioncosExponentialProfileInTheCanopy) {
    const CanopyProfile profile = CanopyProfile::ofStand(20.0f, 2.0f);
    EXPECT_GT(profile.attenuation, 2.0f);
    EXPECT_LT(profile.attenuation, 3.0f); // dense forests
    for (const float z : {20.0f, 15.0f, 10.0f, 2.0f})
        EXPECT_NEAR(profile.mean(z) / std::exp(-profile.attenuation * (1.0f - z / 20.0f)), 1.0f, 1e-4f) << z;
}

TEST(CanopyProfile, IsSmoothAtTheTop) {
    const CanopyProfile profile = CanopyProfile::ofStand(20.0f, 2.0f);
    const float below = profile.mean(20.0f) - profile.mean(19.99f),
                above = profile.mean(20.01f) - profile.mean(20.0f);
    EXPECT_NEAR(above / below, 1.0f, 0.02f);
    EXPECT_NEAR(profile.spread(20.001f).along, profile.spread(19.999f).along, 1e-3f);
}

TEST(CanopyProfile, SpreadMatchesCanopyAndSurfaceLayer) {
    const CanopyProfile profile = CanopyProfile::ofStand(10.0f, 2.0f);
    const WindSpread top = profile.spread(10.0f);
    EXPECT_NEAR(top.along / profile.friction, 1.8f, 1e-4f);
    EXPECT_NEAR(top.up / profile.friction, 1.1f, 1e-4f);
    EXPECT_NEAR(profile.friction * profile.friction / (top.along * top.up), 0.5f,
                0.01f); // as they correlate there
    EXPECT_NEAR(profile.spread(100.0f).along / profile.friction, 2.4f, 1e-4f);
    EXPECT_EQ(profile.skewness(7.0f), 1.0f);
    EXPECT_EQ(profile.skewness(20.0f), 0.0f);
}

/// u* over that of open country with a roughness of 0.03 m, from the top speeds that a profile gives.
double frictionRatio(const CanopyProfile& stand, float reference, float extent) {
    const double open = 0.4 / std::log(static_cast<double>(reference) / 0.03);
    return static_cast<double>(stand.friction * stand.topSpeedRatio(reference, extent)) / open;
}

TEST(CanopyProfile, ASmallWoodDoesNotChangeTheWindAtTheReference) {
    const CanopyProfile profile = CanopyProfile::ofStand(20.0f, 2.0f);
    for (const float extent : {0.0f, 1.0f, 100.0f})
        EXPECT_EQ(profile.topSpeedRatio(60.0f, extent), 1.0f / profile.mean(60.0f)) << extent;
}

TEST(CanopyProfile, AForestSlowsTheLayerOfElliott) {
    for (const double fetch : {500.0, 1000.0, 5000.0}) {
        const CanopyProfile profile = CanopyProfile::ofStand(20.0f, 2.0f);
        const double rough = 20.0 * Raupach(2.0).roughness,
                     layer = 20.0 * Raupach(2.0).displacement + std::pow(rough, 0.2) * std::pow(fetch, 0.8) *
                                                                    (0.75 + 0.03 * std::log(0.03 / rough));
        const auto ratio = static_cast<double>(profile.topSpeedRatio(60.0f, static_cast<float>(2.0 * fetch)));
        EXPECT_NEAR(ratio * static_cast<double>(profile.mean(static_cast<float>(layer))),
                    std::log(layer / 0.03) / std::log(60.0 / 0.03), 0.005)
            << fetch << ": winds differ at the top of the layer of " << layer << " m";
    }
}

TEST(CanopyProfile, AnEndlessForestHasTheGeostrophicDragOfTheEuropeanWindAtlas) {
    const CanopyProfile profile = CanopyProfile::ofStand(20.0f, 2.0f);
    const auto friction =
        [](double roughness) { // under a geostrophic wind of 30 m/s at a latitude of 50 degrees
            double found = 1.0;
            for (int i = 0; i < 50; ++i)
                found = 0.4 * 30.0 / std::hypot(std::log(found / (1.12e-4 * roughness)) - 1.8, 4.5);
            return found;
        };
    const double drag = friction(20.0 * Raupach(2.0).roughness) / friction(0.03);
    EXPECT_NEAR(frictionRatio(profile, 60.0f, 1e9f) / drag, 1.0, 0.05);
    EXPECT_NEAR(frictionRatio(profile, 80.0f, 1e9f) / frictionRatio(profile, 60.0f, 1e9f), 1.0, 1e-4);
    EXPECT_GT(frictionRatio(profile, 60.0f, 1e4f), frictionRatio(profile, 60.0f, 1e9f));
    EXPECT_GT(frictionRatio(profile, 60.0f, 1e3f), frictionRatio(profile, 60.0f, 1e4f));
}

TEST(CanopyProfile, SparseStandIsNearlyOpenCountry) {
    EXPECT_EQ(closureOf(0.0f), 0.0f);
    EXPECT_EQ(closureOf(0.5f), 1.0f);
    EXPECT_GT(CanopyProfile::ofStand(20.0f, 0.001f).mean(2.0f), 0.85f);
}

TEST(CanopyProfile, IsFiniteAtAnyHeight) {
    const CanopyProfile profile = CanopyProfile::ofStand(20.0f, 2.0f);
    for (const float z : {-1e30f, -1.0f, 0.0f, 1e30f, INFINITY, -INFINITY, NAN}) {
        EXPECT_TRUE(std::isfinite(profile.mean(z))) << z;
        EXPECT_TRUE(std::isfinite(profile.spread(z).along)) << z;
    }
}

TEST(SwingingWind, HasTheRequestedMoments) {
    const WindSpread spread{0.6f, 0.48f, 0.33f};
    const SwingingWind wind(1.0f, spread, 1.0f);
    // Sums over a gamma distributed speed and a Gaussian angle.
    const double k = 4.0 / (wind.skewness * wind.skewness), sigma = wind.swing();
    double norm = 0.0, speeds[4] = {}, cosines[4] = {}, angles = 0.0;
    for (double x = 1e-3; x < 40.0 * k; x += 1e-3 * k) {
        const double weight = std::exp((k - 1.0) * std::log(x) - x);
        const double s = wind.mean + wind.deviation * (x - k) / std::sqrt(k);
        norm += weight;
        for (int p = 0; p < 4; ++p)
            speeds[p] += weight * std::pow(s, p);
    }
    for (double t = -8.0; t <= 8.0; t += 0.01) {
        const double weight = std::exp(-0.5 * t * t);
        angles += weight;
        for (int p = 0; p < 4; ++p)
            cosines[p] += weight * std::pow(std::cos(sigma * t), p);
    }
    double u[4];
    for (int p = 0; p < 4; ++p)
        u[p] = speeds[p] / norm * cosines[p] / angles;
    const double variance = u[2] - u[1] * u[1];
    EXPECT_NEAR(u[1], 1.0, 0.005);
    EXPECT_NEAR(std::sqrt(variance), 0.6, 0.005);
    EXPECT_NEAR((u[3] - 3.0 * u[1] * variance - u[1] * u[1] * u[1]) / std::pow(variance, 1.5), 1.0, 0.02);
    EXPECT_NEAR(std::sqrt(speeds[2] / norm - u[2]), 0.48, 0.005);
    EXPECT_NEAR(static_cast<double>(wind.meanPressure()), speeds[2] / norm * cosines[1] / angles, 0.01);
}

} // namespace
