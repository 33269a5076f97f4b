// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace osgTreeWind {

/// A wind of the world as it is met in a frame that stands elsewhere in it, turned and perhaps scaled: places
/// are taken to the world, velocities turned back. The frame's own motion makes no wind. Of a wind that is
/// moved already it takes the wind within, and one move that is both.
class MovedWind final : public WindField {
public:
    /// Along which z heights above the ground are counted.
    enum class Up { OfTheWorld, OfTheFrame };

    /// @param world null is calm. @param frameToWorld takes places of the frame to the world.
    MovedWind(WindFieldPtr world, const glm::dmat4& frameToWorld, Up up = Up::OfTheWorld);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    WindFieldPtr withoutGusts() const override;
    WindFieldPtr changedBesideSources(const WindChange& change) const override;

private:
    /// A wind of a frame as it is met in the world: the inverse of `moved`.
    MovedWind(const MovedWind& moved, WindFieldPtr ofFrame);
    WindPlace inWorld(const WindPlace& place) const;

    WindFieldPtr _world;
    glm::dmat4 _frameToWorld;
    glm::dmat3 _turnBack; ///< Of velocities, from the world to the frame.
    Up _up;
    double _rise; ///< Heights in the world for one in the frame.
};

} // namespace osgTreeWind
