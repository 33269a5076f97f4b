// SPDX-License-Identifier: MIT
#include <tests/wind/Extremes.h>
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr double airDensity = 1.225, pi = glm::pi<double>();

glm::dvec3 at(const WindSource& source, const glm::vec3& place, double time = 0.0) {
    return glm::dvec3(withSources(nullptr, {source}).velocity(WindPlace(place), time));
}

WindSource rotor(double hub) {
    WindSource source;
    source.position = {0.0, 0.0, hub};
    source.radius = 8.0;
    source.thrust = 70000.0;
    source.turbulence = 0.0;
    return source;
}

double inducedSpeed(const WindSource& source) {
    return std::sqrt(source.thrust / (2.0 * airDensity * pi * source.radius * source.radius));
}

TEST(SourceFlow, RotorColumnFollowsMomentumTheory) {
    const WindSource source = rotor(200.0);
    const double induced = inducedSpeed(source);
    EXPECT_NEAR(-at(source, {0.0f, 0.0f, 200.0f}).z, induced, 0.02 * induced) << "at the disk";
    EXPECT_NEAR(-at(source, {0.0f, 0.0f, 160.0f}).z, 2.0 * induced, 0.05 * induced) << "five radii below";
    EXPECT_LT(-at(source, {0.0f, 0.0f, 224.0f}).z, 0.06 * induced) << "three radii above";
    double momentum = 0.0;
    const double step = 0.02, depth = 24.0;
    for (double r = 0.5 * step; r < 40.0; r += step) {
        const double down = at(source, {static_cast<float>(r), 0.0f, static_cast<float>(200.0 - depth)}).z;
        momentum += airDensity * down * down * 2.0 * pi * r * step;
    }
    const double wake = 1.0 + depth / std::hypot(depth, source.radius); // over the induced velocity
    EXPECT_NEAR(momentum, 0.5 * wake * source.thrust, 0.02 * source.thrust);
}

TEST(SourceFlow, RotorOutwashIsTheMeasuredRadialWallJet) {
    const WindSource source = rotor(20.0);
    for (const double r : {30.0, 60.0}) {
        double fastest = 0.0, momentum = 0.0, half = 0.0;
        const double step = 0.01;
        for (double z = 0.5 * step; z < 40.0; z += step) {
            const double out = at(source, {0.0f, static_cast<float>(r), static_cast<float>(z)}).y;
            momentum += airDensity * out * out * 2.0 * pi * r * step;
            if (out >= 0.5 * fastest)
                half = z;
            fastest = std::max(fastest, out);
        }
        const double expected =
            1.32 * std::sqrt(source.thrust / airDensity) / 20.0 * std::pow(r / 20.0, -1.1);
        EXPECT_NEAR(fastest, expected, 0.02 * expected) << r;
        EXPECT_NEAR(half, 0.098 * 20.0 * std::pow(r / 20.0, 0.9), 0.05 * half) << r;
        EXPECT_LT(momentum, source.thrust) << r;
        EXPECT_GT(momentum, 0.5 * source.thrust) << "most momentum continues along the ground";
    }
    EXPECT_EQ(glm::length(at(source, {0.0f, 0.0f, 0.0f})), 0.0) << "stagnation point";
}

/// The momentum does not depend on the height H of the rotor; the outwash is proportional to (r/H)^-1.1 / H.
TEST(SourceFlow, HigherRotorIsWeakerBelowAndSimilarFarAway) {
    const auto fastest = [](double hub, float r) {
        double most = 0.0;
        for (float z = 0.05f; z < 20.0f; z += 0.05f)
            most = std::max(most, at(rotor(hub), {r, 0.0f, z}).x);
        return most;
    };
    EXPECT_NEAR(fastest(60.0, 80.0f) / fastest(20.0, 80.0f), std::pow(3.0, 0.1), 0.02);
    EXPECT_LT(at(rotor(200.0), {0.0f, 0.0f, 10.0f}).z, 0.0);
    EXPECT_LT(-at(rotor(300.0), {0.0f, 0.0f, 10.0f}).z, 0.5 * -at(rotor(60.0), {0.0f, 0.0f, 10.0f}).z);
}

WindSource fan() {
    WindSource source;
    source.kind = WindSource::Kind::Jet;
    source.position = {5.0, 0.0, 3.0};
    source.radius = 0.5;
    source.speed = 20.0;
    source.toward = glm::half_pi<float>(); // east
    source.turbulence = 0.0;
    return source;
}

TEST(SourceFlow, JetDecaysAndSpreadsLikeARoundJet) {
    const WindSource source = fan();
    EXPECT_NEAR(at(source, {6.0f, 0.0f, 3.0f}).x, 20.0, 0.1) << "core";
    EXPECT_NEAR(at(source, {25.0f, 0.0f, 3.0f}).x, 20.0 * 5.8 / 16.0, 0.01) << "20 diameters downstream";
    EXPECT_NEAR(at(source, {25.0f, static_cast<float>(0.094 * 16.0), 3.0f}).x, 10.0 * 5.8 / 16.0, 0.01);
    EXPECT_EQ(glm::length(at(source, {4.0f, 0.0f, 3.0f})), 0.0) << "behind it";
    for (const float x : {6.0f, 20.0f, 60.0f}) {
        double momentum = 0.0;
        const double step = 0.01;
        for (double r = 0.5 * step; r < 40.0; r += step) {
            const double u = at(source, {5.0f + x, static_cast<float>(r), 3.0f}).x;
            momentum += u * u * 2.0 * pi * r * step;
        }
        EXPECT_NEAR(momentum / (400.0 * pi * 0.25), 1.0, 0.06) << x;
    }
}

TEST(SourceFlow, JetFollowsItsDirectionAndElevation) {
    WindSource source = fan();
    source.toward = glm::pi<float>();
    source.elevation = glm::radians(30.0f);
    const glm::dvec3 along(0.0, -std::sqrt(0.75), 0.5);
    const glm::dvec3 wind = at(source, glm::vec3(source.position + 3.0 * along));
    EXPECT_LT(glm::length(wind - 20.0 * along), 0.1);
}

TEST(SourceFlow, VortexPeaksAtItsRadiusAndDecaysInversely) {
    WindSource source;
    source.kind = WindSource::Kind::Vortex;
    source.radius = 4.0;
    source.speed = 15.0;
    source.height = 30.0;
    source.turbulence = 0.0;
    EXPECT_NEAR(at(source, {4.0f, 0.0f, 10.0f}).y, 15.0, 0.01) << "counter-clockwise from above";
    double fastest = 0.0;
    for (float x = 0.1f; x < 40.0f; x += 0.1f)
        fastest = std::max(fastest, at(source, {x, 0.0f, 10.0f}).y);
    EXPECT_NEAR(fastest, 15.0, 0.01);
    EXPECT_NEAR(at(source, {40.0f, 0.0f, 10.0f}).y / at(source, {80.0f, 0.0f, 10.0f}).y, 2.0, 1e-3);
    EXPECT_EQ(glm::length(at(source, {4.0f, 0.0f, 40.0f})), 0.0) << "above it";
    EXPECT_EQ(glm::length(at(source, {0.0f, 0.0f, 10.0f})), 0.0) << "its eye";
}

TEST(SourceFlow, ShelterReducesOnlyTheWind) {
    WindSource shelter;
    shelter.kind = WindSource::Kind::Shelter;
    shelter.radius = 10.0;
    shelter.height = 6.0;
    shelter.share = 0.25;
    WindSource blower = fan();
    const auto wind = std::make_shared<UniformWind>(glm::vec3(0.0f, 8.0f, 0.0f));
    const LayeredWind both = withSources(wind, {shelter, blower});
    EXPECT_EQ(both.velocity({0.0f, 3.0f, 2.0f}, 0.0), glm::vec3(0.0f, 2.0f, 0.0f));
    EXPECT_EQ(both.velocity({0.0f, 30.0f, 2.0f}, 0.0), glm::vec3(0.0f, 8.0f, 0.0f));
    EXPECT_EQ(both.velocity({0.0f, 3.0f, 20.0f}, 0.0), glm::vec3(0.0f, 8.0f, 0.0f));
    EXPECT_NEAR(both.velocity({6.0f, 0.0f, 3.0f}, 0.0).x, 20.0f, 0.1f)
        << "a fan in the shelter is not reduced";
    float last = 2.0f;
    for (float y = 9.0f; y < 13.0f; y += 0.01f) {
        const float now = both.velocity({0.0f, y, 2.0f}, 0.0).y;
        EXPECT_LT(std::abs(now - last), 0.06f) << "no step at " << y;
        last = now;
    }
}

WindSource lorry() {
    WindSource source;
    source.kind = WindSource::Kind::Vehicle;
    source.velocity = {0.0, 25.0, 0.0};
    source.radius = 1.25;
    source.height = 4.0;
    source.turbulence = 0.0;
    return source;
}

/// Eskridge and Thompson (1982) measured both exponents from 10 to 80 heights behind the vehicle.
TEST(SourceFlow, VehicleWakeConservesItsMomentAndDecaysAsMeasured) {
    WindSource without = lorry(); // a wake
    without.dragArea = 0.0;
    double nearSpeed = 0.0, nearHeight = 0.0;
    for (const double behind : {40.0, 320.0}) {
        double moment = 0.0, fastest = 0.0, highest = 0.0;
        const double step = 0.1;
        for (double z = 0.5 * step; z < 25.0; z += step)
            for (double x = -25.0; x < 25.0; x += step) {
                const glm::vec3 place(static_cast<float>(x), static_cast<float>(-behind),
                                      static_cast<float>(z));
                const double u = at(lorry(), place).y - at(without, place).y;
                moment += u * z * step * step;
                if (u > fastest) {
                    fastest = u;
                    highest = z;
                }
            }
        const double expected = 0.5 * 6.0 * 25.0 * 2.0; // half of Cd A U at half the height
        EXPECT_NEAR(moment, expected, 0.03 * expected) << behind;
        if (behind > 100.0) {
            EXPECT_NEAR(std::log(fastest / nearSpeed) / std::log(8.0), -0.75, 0.03);
            EXPECT_NEAR(std::log(highest / nearHeight) / std::log(8.0), 0.25, 0.03);
        }
        nearSpeed = fastest;
        nearHeight = highest;
    }
    EXPECT_GT(nearSpeed, 0.5) << "320 m behind";
    EXPECT_LT(glm::length(at(lorry(), {0.0f, -320.0f, 0.0f})), 0.01) << "no wind at the ground";
}

/// A crosswind reduces the induced velocity for the same thrust and carries the column away.
TEST(SourceFlow, WindDeflectsARotorColumn) {
    const WindSource source = rotor(200.0);
    const double calm = inducedSpeed(source), air = 9.0;
    const WindFieldPtr wind = std::make_shared<UniformWind>(glm::vec3(static_cast<float>(air), 0.0f, 0.0f));
    const auto down = [&](double x, double z) {
        const WindPlace place(static_cast<float>(x), 0.0f, static_cast<float>(z));
        return -static_cast<double>(withSources(wind, {source}).velocity(place, 0.0).z);
    };
    const double induced = down(0.0, 200.0);
    EXPECT_NEAR(induced * std::hypot(air, induced), calm * calm, 0.03 * calm * calm) << "Glauert";
    // A particle that sinks with the column stays on its axis.
    double x = 0.0, z = 200.0;
    const double step = 0.01; // seconds
    while (z > 150.0) {
        x += step * air;
        z -= step * induced * (1.0 + (200.0 - z) / std::hypot(200.0 - z, source.radius));
    }
    const double axis = down(x, z);
    EXPECT_GT(axis, 1.8 * induced);
    EXPECT_NEAR(down(x - 5.0, z), down(x + 5.0, z), 0.02 * axis);
    EXPECT_LT(down(x - 20.0, z), 0.01 * axis);
    EXPECT_LT(down(0.0, z), 0.01 * axis) << "calm below the rotor";
}

TEST(SourceFlow, RotorDriftingWithTheWindIsAsInACalm) {
    WindSource source = rotor(30.0);
    source.velocity = {6.0, 2.0, 0.0};
    const WindFieldPtr wind = std::make_shared<UniformWind>(glm::vec3(6.0f, 2.0f, 0.0f));
    const glm::vec3 drifting = withSources(wind, {source}).velocity(WindPlace(9.0f, 4.0f, 12.0f), 0.0);
    const glm::dvec3 calm = at(rotor(30.0), {9.0f, 4.0f, 12.0f});
    EXPECT_LT(glm::length(glm::dvec3(drifting) - glm::dvec3(6.0, 2.0, 0.0) - calm), 1e-4);
}

TEST(SourceFlow, VehicleWakePointsAlongTheRelativeWind) {
    WindSource without = lorry(); // drives to the north at 25 m/s
    without.dragArea = 0.0;
    const auto wakeIn = [&](const glm::vec3& air, float x, float y) {
        const WindFieldPtr wind = std::make_shared<UniformWind>(air);
        const WindPlace place(x, y, 2.0f);
        return withSources(wind, {lorry()}).velocity(place, 0.0) -
               withSources(wind, {without}).velocity(place, 0.0);
    };
    const glm::vec3 across(5.0f, 0.0f, 0.0f);
    EXPECT_GT(glm::length(wakeIn(across, 20.0f, -100.0f)), 0.5f) << "drifted 20 m downwind at 100 m behind";
    EXPECT_LT(glm::length(wakeIn(across, 0.0f, -100.0f)), 0.01f);
    EXPECT_EQ(glm::length(wakeIn({0.0f, 25.0f, 0.0f}, 0.0f, -100.0f)), 0.0f) << "driving with the wind";
    EXPECT_GT(wakeIn({0.0f, -10.0f, 0.0f}, 0.0f, -100.0f).y, wakeIn({}, 0.0f, -100.0f).y)
        << "driving against the wind";
}

/// The volume swept by the body flows out at the front and in at the rear.
TEST(SourceFlow, VehicleDisplacesTheAir) {
    WindSource source = lorry();
    source.dragArea = 0.0; // no wake
    const auto outThrough = [&](float y0, float y1) {
        double out = 0.0;
        const float step = 0.25f, half = 6.0f;
        for (float a = -half + 0.5f * step; a < half; a += step)
            for (float z = 0.5f * step; z < half; z += step) // two walls along, two across
                out += at(source, {a, y1, z}).y - at(source, {a, y0, z}).y;
        for (float y = y0 + 0.5f * step; y < y1; y += step) {
            for (float z = 0.5f * step; z < half; z += step)
                out += at(source, {half, y, z}).x - at(source, {-half, y, z}).x;
            for (float x = -half + 0.5f * step; x < half; x += step)
                out += at(source, {x, y, half}).z - at(source, {x, y, 0.0f}).z;
        }
        return out * step * step;
    };
    const double swept = 25.0 * 2.5 * 4.0;
    EXPECT_NEAR(outThrough(8.0f, 24.0f), swept, 0.05 * swept) << "around the front at y = 16";
    EXPECT_NEAR(outThrough(-8.0f, 8.0f), -swept, 0.05 * swept) << "around the rear";
    EXPECT_EQ(at(source, {3.0f, 20.0f, 0.0f}).z, 0.0) << "no flow through the ground";
    EXPECT_GT(at(source, {0.0f, 24.0f, 2.0f}).y, 0.3) << "pushed forward ahead";
    source.velocity = glm::dvec3(0.0);
    EXPECT_EQ(glm::length(at(source, {3.0f, 16.0f, 2.0f})), 0.0) << "parked";
}

TEST(SourceFlow, SourceMovesWithItsVelocity) {
    WindSource source = fan();
    source.velocity = {0.0, 12.0, 0.0};
    EXPECT_LT(glm::length(at(source, {6.0f, 24.0f, 3.0f}, 2.0) - glm::dvec3(20.0, 0.0, 0.0)), 0.1);
    EXPECT_LT(glm::length(at(source, {6.0f, 0.0f, 3.0f}, 2.0)), 0.1) << "at its former place";
}

TEST(SourceFlow, TurbulenceHasItsIntensityAndTravels) {
    WindSource source = fan();
    const glm::vec3 place(25.0f, 0.0f, 3.0f);
    const glm::dvec3 steady = at(source, place);
    source.turbulence = 0.25;
    glm::dvec3 sum(0.0), squares(0.0);
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 off = at(source, place, 0.05 * i) - steady;
        sum += off;
        squares += off * off;
    }
    EXPECT_LT(glm::length(sum / double(count)), 0.02 * glm::length(steady));
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(std::sqrt(squares[axis] / count), 0.25 * glm::length(steady), 0.02 * glm::length(steady));
    EXPECT_LT(glm::length(at(source, place, 3.0) - at(source, place, 3.0001)), 0.05) << "no jumps";
    EXPECT_EQ(at(source, place, 3.0), at(source, place, 3.0)) << "reproducible";
}

TEST(SourceFlow, IsFiniteForAnySourceAndPlace) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), huge = 1e300;
    for (const auto kind : {WindSource::Kind::Rotor, WindSource::Kind::Jet, WindSource::Kind::Vortex,
                            WindSource::Kind::Shelter, WindSource::Kind::Vehicle})
        for (const double number : {nan, huge, -huge, 0.0, 1e-300}) {
            WindSource source;
            source.kind = kind;
            expectFiniteEverywhere(withSources(std::make_shared<UniformWind>(glm::vec3(1.0f)), {source}));
            source.position = source.velocity = glm::dvec3(number);
            source.toward = source.elevation = static_cast<float>(number);
            source.radius = source.thrust = source.speed = source.height = source.share = source.turbulence =
                number;
            expectFiniteEverywhere(withSources(nullptr, {source}));
        }
}

} // namespace
