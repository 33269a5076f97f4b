// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <array>

namespace osgTreeWind {

/// How much wider the bark of a stem is near the ground, with a few roots that stand out (after Weber and
/// Penn 1995, who have it over a tenth of the tree; at most 1.2 m here). The wood that bends does not know.
class StemFoot {
public:
    /// Further rings that show it, as shares of its height.
    static constexpr std::array<float, 4> rings{0.07f, 0.18f, 0.36f, 0.65f};

    explicit StemFoot(const Skeleton& skeleton);

    float height() const { return _height; } ///< Metres; 0: the stem is as wide as its skeleton.
    /// Factor on the radius, at least 1. @param z above the ground, metres. @param angle around the stem.
    float widening(float z, float angle) const;

private:
    float _flare, _height;
};

} // namespace osgTreeWind
