// SPDX-License-Identifier: MIT
#include <tests/wind/Winds.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/wind/SourceGrid.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>
#include <limits>

using namespace osgTreeWind;

namespace {

/// Sources of all kinds in a square of 4 km; half of them move.
std::vector<WindSource> manySources(std::size_t count) {
    Random random(5);
    std::vector<WindSource> sources(count);
    for (std::size_t i = 0; i < count; ++i) {
        WindSource& source = sources[i];
        source.kind = static_cast<WindSource::Kind>(i % 6);
        source.position = {2000.0f * random.symmetric(), 2000.0f * random.symmetric(),
                           source.kind == WindSource::Kind::Rotor ? 25.0 : 0.0};
        if (i % 2 == 0)
            source.velocity = {20.0f * random.symmetric(), 20.0f * random.symmetric(), 0.0};
        source.thrust = 200.0; // a drone
        source.dragArea = 0.7; // a car
        source.height = 1.5;
        source.charge = 0.01;
        source.radius = 0.5;
        source.speed = 6.0f * random.symmetric();
        source.toward = glm::pi<float>() * random.symmetric();
        source.time = 20.0f * random.uniform();
    }
    return sources;
}

/// Reference: evaluates all sources at a place.
glm::vec3 bySources(const std::vector<WindSource>& sources, const WindFieldPtr& wind, const WindPlace& place,
                    double time) {
    float share = 1.0f;
    glm::vec3 added(0.0f);
    for (const WindSource& source : sources) {
        const SourceFlow flow(source);
        const float ground = place.position.z - place.height;
        share *= flow.shareOfWind(place, time);
        added += flow.velocity(place, time, wind->velocity(flow.ambientWindPlace(ground, time), time));
    }
    return share * wind->velocity(place, time) + added;
}

TEST(SourceGrid, FindsEachSourceThatReachesAPlace) {
    const std::vector<WindSource> sources = manySources(300);
    const WindFieldPtr wind = std::make_shared<UniformWind>(glm::vec3(3.0f, -2.0f, 0.0f));
    const LayeredWind many = withSources(wind, sources);
    Random random(9);
    for (const double time : {0.0, 3.0, 400.0, -50.0, 3.5, 1e7})
        for (int i = 0; i < 60; ++i) {
            glm::vec3 at(2200.0f * random.symmetric(), 2200.0f * random.symmetric(),
                         20.0f * random.uniform());
            if (i % 3 == 0) // beside a source
                at = glm::vec3(sources[static_cast<std::size_t>(i)].position +
                               time * sources[static_cast<std::size_t>(i)].velocity) +
                     glm::vec3(3.0f, 2.0f, 1.0f);
            const WindPlace place(at, at.z - 4.0f);
            EXPECT_EQ(many.velocity(place, time), bySources(sources, wind, place, time)) << i << ", " << time;
        }
}

TEST(SourceGrid, SkipsDistantSources) {
    const SourceGrid grid(manySources(2000));
    std::size_t asked = 0;
    for (float x = -1900.0f; x < 1900.0f; x += 190.0f)
        for (float y = -1900.0f; y < 1900.0f; y += 190.0f)
            asked += grid.at(0.0)->near({x, y, 0.0f}).size;
    EXPECT_LT(asked, 400u * 400u) << "less than 20 % of the sources";
    EXPECT_EQ(grid.at(0.0)->near({1e9f, 0.0f, 0.0f}).size, 0u);
    grid.at(0.0)->near(glm::vec3(std::numeric_limits<float>::quiet_NaN()));
}

TEST(SourceGrid, SourcesFadeOutAtTheirReach) {
    for (int kind = 0; kind < 6; ++kind) {
        WindSource source;
        source.kind = static_cast<WindSource::Kind>(kind);
        source.position.z = source.kind == WindSource::Kind::Rotor ? 20.0 : 0.0;
        source.toward = glm::half_pi<float>();
        source.velocity.x = source.kind == WindSource::Kind::Vehicle ? -20.0 : 0.0;
        source.turbulence = 0.0;
        source.speed = 20.0;
        const LayeredWind wind = withSources(nullptr, {source});
        glm::vec3 last = wind.velocity(WindPlace(150.0f, 0.0f, 2.0f), 0.0); // behind a jet's core
        for (float x = 150.0f; x < 20000.0f; x *= 1.0005f) {
            const glm::vec3 next = wind.velocity(WindPlace(x, 0.0f, 2.0f), 0.0);
            EXPECT_LT(glm::length(next - last), 0.1f) << kind << " at " << x;
            last = next;
        }
        EXPECT_LT(glm::length(last), 1e-6f) << kind;
    }
}

TEST(SourceGrid, FadeAtTheReachAffectsOnlyWeakWind) {
    WindSource lorry;
    lorry.kind = WindSource::Kind::Vehicle;
    lorry.velocity = {-25.0, 0.0, 0.0};
    lorry.height = 4.0;
    lorry.turbulence = 0.0;
    const LayeredWind wind = withSources(nullptr, {lorry});
    float end = 0.0f;
    for (float x = 10.0f; x < 20000.0f; x += 5.0f)
        if (glm::length(wind.velocity(WindPlace(x, 0.0f, 3.0f), 0.0)) > 0.0f)
            end = x;
    EXPECT_GT(end, 1000.0f) << "the wake of a lorry is long";
    EXPECT_LT(glm::length(wind.velocity(WindPlace(0.79f * end, 0.0f, 4.0f), 0.0)), 0.35f);
}

} // namespace
