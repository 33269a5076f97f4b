// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/UniformWind.h>

#include <osgTreeWind/wind/FiniteVelocity.h>

namespace osgTreeWind {

UniformWind::UniformWind(const glm::vec3& velocity) : _velocity(calmUnlessFinite(velocity)) {}

glm::vec3 UniformWind::velocity(const WindPlace&, double) const {
    return _velocity;
}

} // namespace osgTreeWind
