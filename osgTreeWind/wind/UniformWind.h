// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// The same velocity everywhere and always.
class OSGTREEWIND_EXPORT UniformWind final : public WindField {
public:
    /// @param velocity m/s toward; calm when a component is not finite.
    explicit UniformWind(const glm::vec3& velocity);

    glm::vec3 velocity(const WindPlace& place, double time) const override;

    const glm::vec3& velocity() const { return _velocity; } ///< As given.

private:
    glm::vec3 _velocity;
};

} // namespace osgTreeWind
