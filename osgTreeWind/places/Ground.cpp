// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/Ground.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Range.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace osgTreeWind {

Ground::~Ground() = default;

std::optional<double> heightOf(const Ground& ground, const glm::dvec2& place) {
    const std::optional<double> height = ground.height(place);
    return height && worldCoordinates.contains(*height) ? height : std::nullopt;
}

std::optional<double> footHeight(const Ground& ground, const glm::dvec2& place, double radius) {
    constexpr int samples = 8;
    std::optional<double> lowest = heightOf(ground, place);
    for (int i = 0; lowest && i < samples; ++i) {
        const double angle = glm::two_pi<double>() * i / samples;
        const auto rim = heightOf(ground, place + radius * glm::dvec2(math::cos(angle), math::sin(angle)));
        lowest = std::min(*lowest, rim.value_or(*lowest));
    }
    return lowest;
}

} // namespace osgTreeWind
