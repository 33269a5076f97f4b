// SPDX-License-Identifier: MIT
// Properties of every wind at every place and time.
#include <tests/wind/Winds.h>

#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindDirection.h>

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace osgTreeWind {

namespace {

/// Multiples of 0.001, so that counterexamples are short.
rc::Gen<double> number(double low, double high) {
    return rc::gen::map(rc::gen::inRange(static_cast<int>(1000 * low), static_cast<int>(1000 * high) + 1),
                        [](int thousandths) { return thousandths / 1000.0; });
}

rc::Gen<glm::dvec3> within(double reach, double low, double high) {
    return rc::gen::apply([](double x, double y, double z) { return glm::dvec3(x, y, z); },
                          number(-reach, reach), number(-reach, reach), number(low, high));
}

/// A jet or vortex: kinds that add to the wind and are not deflected by it.
WindSource anySource() {
    WindSource source;
    source.kind = *rc::gen::element(WindSource::Kind::Jet, WindSource::Kind::Vortex);
    source.position = *within(30.0, 0.0, 30.0);
    source.velocity = *within(5.0, -1.0, 1.0);
    source.radius = *number(0.1, 20.0);
    source.speed = *number(-50.0, 50.0);
    source.toward = static_cast<float>(glm::radians(*number(-360.0, 360.0)));
    source.elevation = static_cast<float>(glm::radians(*number(-90.0, 90.0)));
    source.height = *number(0.1, 40.0);
    source.turbulence = *number(0.0, 1.0);
    return source;
}

WindPlace anyPlace() {
    return WindPlace(glm::vec3(*within(50.0, 0.0, 40.0)), 0.0f);
}

bool near(const glm::vec3& a, const glm::vec3& b, float tolerance) {
    return glm::distance(a, b) <= tolerance * (1.0f + glm::length(a) + glm::length(b));
}

} // namespace

RC_GTEST_PROP(WindProperty, SourcesAddUp, ()) {
    const auto wind = std::make_shared<UniformWind>(glm::vec3(*within(20.0, -2.0, 2.0)));
    const WindSource one = anySource(), other = anySource();
    const WindPlace place = anyPlace();
    const double time = *number(0.0, 100.0);
    const auto alone = [&](const WindSource& source) {
        return withSources(nullptr, {source}).velocity(place, time);
    };
    RC_ASSERT(near(withSources(wind, {one, other}).velocity(place, time),
                   wind->velocity(place, time) + alone(one) + alone(other), 1e-5f));
}

RC_GTEST_PROP(WindProperty, MovedSourceMovesItsFlow, ()) {
    WindSource source = anySource();
    WindPlace place = anyPlace();
    const double time = *number(0.0, 100.0);
    const glm::vec3 before = withSources(nullptr, {source}).velocity(place, time);
    const glm::dvec3 moved = *within(100.0, 0.0, 0.0);
    source.position += moved;
    place.position += glm::vec3(moved);
    RC_ASSERT(near(withSources(nullptr, {source}).velocity(place, time), before, 2e-2f));
}

RC_GTEST_PROP(WindProperty, TurnedSourceTurnsItsFlow, ()) {
    WindSource source = anySource();
    source.turbulence = 0.0; // eddies stand as they are
    const WindPlace place = anyPlace();
    const double time = *number(0.0, 20.0), degrees = *number(0.0, 360.0);
    const double sine = std::sin(glm::radians(degrees)), cosine = std::cos(glm::radians(degrees));
    const auto turned = [&](const glm::dvec3& v) { // clockwise from above, as `toward` counts
        return glm::dvec3(cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, v.z);
    };
    const glm::dvec3 before(withSources(nullptr, {source}).velocity(place, time));
    source.position = turned(source.position);
    source.velocity = turned(source.velocity);
    source.toward =
        std::remainder(source.toward + static_cast<float>(glm::radians(degrees)), glm::two_pi<float>());
    const WindPlace there(glm::vec3(turned(place.position)), 0.0f);
    RC_ASSERT(near(withSources(nullptr, {source}).velocity(there, time), glm::vec3(turned(before)), 2e-2f));
}

RC_GTEST_PROP(WindProperty, GridStaysWithinTheRangeOfItsPoints, ()) {
    GridWind::Grid grid;
    grid.points = {*rc::gen::inRange(1, 5), *rc::gen::inRange(1, 5), *rc::gen::inRange(1, 4)};
    grid.origin = *within(20.0, -5.0, 5.0);
    grid.cell = {*number(0.1, 20.0), *number(0.1, 20.0), *number(0.1, 20.0)};
    const auto count = static_cast<std::size_t>(3 * grid.points.x * grid.points.y * grid.points.z);
    for (const double value : *rc::gen::container<std::vector<double>>(count, number(-30.0, 30.0)))
        grid.values.push_back(static_cast<float>(value));
    const auto wind = GridWind::create(grid);
    RC_ASSERT(wind.ok());
    const glm::vec3 velocity = wind.value()->velocity(anyPlace(), *number(-10.0, 10.0));
    for (std::size_t axis = 0; axis < 3; ++axis) {
        float low = 30.0f, high = -30.0f;
        for (std::size_t i = axis; i < count; i += 3)
            low = std::min(low, grid.values[i]), high = std::max(high, grid.values[i]);
        const float component = velocity[static_cast<glm::length_t>(axis)];
        RC_ASSERT(component >= low - 1e-4f);
        RC_ASSERT(component <= high + 1e-4f);
    }
}

RC_GTEST_PROP(WindProperty, AdjustmentsCombine, ()) {
    const auto wind = std::make_shared<UniformWind>(glm::vec3(*within(30.0, -5.0, 5.0)));
    const auto halfTurns = [] { return glm::radians(static_cast<float>(*number(-180.0, 180.0))); };
    const WindAdjustment first{*number(0.0, 3.0), halfTurns()}, second{*number(0.0, 3.0), halfTurns()};
    const WindPlace place = anyPlace();
    const LayeredWind both =
                          withAdjustment(wind, {first.strength * second.strength, first.turn + second.turn}),
                      nested =
                          withAdjustment(std::make_shared<LayeredWind>(withAdjustment(wind, first)), second);
    RC_ASSERT(near(nested.velocity(place, 0.0), both.velocity(place, 0.0), 1e-5f));
}

RC_GTEST_PROP(WindProperty, ReadingConvertsBackToItsVelocity, ()) {
    const glm::vec3 velocity(*within(60.0, 0.0, 0.0));
    for (const DirectionSense sense : {DirectionSense::From, DirectionSense::Toward})
        RC_ASSERT(near(windVelocity(windReading(velocity, sense), sense), velocity, 1e-5f));
}

} // namespace osgTreeWind
