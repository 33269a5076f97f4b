// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <array>

namespace osgTreeWind {

/// Widening of a stem's bark near the ground (after Weber and Penn 1995, who use a tenth of the tree's
/// height; here at most 1.2 m), most of it in a few roots that run down and out. Does not affect the
/// stiffness of the stem.
class StemFoot {
public:
    /// Heights of additional rings, over the height of the foot.
    static constexpr std::array<float, 4> rings{0.07f, 0.18f, 0.36f, 0.65f};

    explicit StemFoot(const Skeleton& skeleton);

    float height() const { return _height; } ///< Metres; 0: no widening.
    /// How far the bark goes on below the ground, metres, so that no gap opens where that is rough.
    float depth() const { return 0.1f * _height; }
    /// Factor on the radius, at least 1. @param z above the ground, metres. @param angle around it, radians.
    float widening(float z, float angle) const;
    /// Normal of the widened bark: its parts outward, around in the direction of the angle, and upward.
    /// @param radius of the stem that widens, metres.
    glm::vec3 normal(float z, float angle, float radius) const;

private:
    float _flare, _height;
};

} // namespace osgTreeWind
