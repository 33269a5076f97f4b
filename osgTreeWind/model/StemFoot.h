// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <array>

namespace osgTreeWind {

/// Widening of a stem's bark near the ground, with a few buttress roots (after Weber and Penn 1995, who use a
/// tenth of the tree's height; here at most 1.2 m). Does not affect the stiffness of the stem.
class StemFoot {
public:
    /// Heights of additional rings, over the height of the foot.
    static constexpr std::array<float, 4> rings{0.07f, 0.18f, 0.36f, 0.65f};

    explicit StemFoot(const Skeleton& skeleton);

    float height() const { return _height; } ///< Metres; 0: no widening.
    /// Factor on the radius, at least 1. @param z above the ground, metres. @param angle around it, radians.
    float widening(float z, float angle) const;

private:
    float _flare, _height;
};

} // namespace osgTreeWind
