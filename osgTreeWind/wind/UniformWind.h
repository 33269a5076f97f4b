// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// A wind that is constant in time and, at the same height above the ground, in space.
///
///     report(forest->setWind(std::make_shared<UniformWind>(glm::vec3(6.0f, 0.0f, 0.0f)))); // from the west
class OSGTREEWIND_EXPORT UniformWind final : public WindField {
public:
    /// @param velocity m/s toward; 0 is used if a component is not finite.
    /// @param profile scales the velocity with the height; empty, or not valid(): the same at all heights.
    explicit UniformWind(const glm::vec3& velocity, const std::optional<LogProfile>& profile = {});

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    std::optional<LogProfile> profile() const override { return _profile; }

    const glm::vec3& velocity() const { return _velocity; } ///< m/s toward, at the height of the profile.

private:
    glm::vec3 _velocity;
    std::optional<LogProfile> _profile;
};

} // namespace osgTreeWind
