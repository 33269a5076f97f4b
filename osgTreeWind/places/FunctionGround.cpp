// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/FunctionGround.h>

#include <cmath>
#include <limits>
#include <utility>

namespace osgTreeWind {

FunctionGround::FunctionGround(Function function, const GroundArea& area)
    : _function(std::move(function)), _area(area) {}

std::optional<double> FunctionGround::height(const glm::dvec2& place) const {
    const bool isInside = place.x >= _area.low.x && place.x <= _area.high.x && place.y >= _area.low.y &&
                          place.y <= _area.high.y;
    const double height =
        isInside && _function ? _function(place.x, place.y) : std::numeric_limits<double>::quiet_NaN();
    return std::isfinite(height) ? std::optional(height) : std::nullopt;
}

} // namespace osgTreeWind
