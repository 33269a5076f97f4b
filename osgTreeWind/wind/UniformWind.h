// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// A wind that is constant in space and time.
///
///     report(forest->setWind(std::make_shared<UniformWind>(glm::vec3(6.0f, 0.0f, 0.0f)))); // from the west
class OSGTREEWIND_EXPORT UniformWind final : public WindField {
public:
    /// @param velocity m/s toward; 0 is used if a component is not finite.
    explicit UniformWind(const glm::vec3& velocity);

    glm::vec3 velocity(const WindPlace& place, double time) const override;

    const glm::vec3& velocity() const { return _velocity; } ///< m/s toward.

private:
    glm::vec3 _velocity;
};

} // namespace osgTreeWind
