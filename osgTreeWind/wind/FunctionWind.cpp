// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/FunctionWind.h>

#include <osgTreeWind/wind/FiniteVelocity.h>

#include <utility>

namespace osgTreeWind {

FunctionWind::FunctionWind(Function function) : _function(std::move(function)) {}

glm::vec3 FunctionWind::velocity(const WindPlace& place, double time) const {
    return _function ? calmUnlessFinite(_function(place.position, time)) : glm::vec3(0.0f);
}

} // namespace osgTreeWind
