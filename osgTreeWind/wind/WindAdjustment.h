// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

#include <glm/mat3x3.hpp>

namespace osgTreeWind {

/// Another wind, stronger or weaker, and turned: what blows at a place and time, times a factor and turned
/// about the vertical there. Of a wind that is adjusted already it takes the wind within, and both at once.
class AdjustedWind final : public WindField {
public:
    struct Adjustment {
        double strength = 1.0; ///< Factor of velocities, [0, 10].
        double turn = 0.0;     ///< Degrees clockwise from above, [-360, 360].
    };

    /// @param inner null is calm. What is out of range is held within it.
    AdjustedWind(WindFieldPtr inner, const Adjustment& adjustment);

    glm::vec3 velocity(const WindPlace& place, double time) const override;
    void sample(const WindPlace* places, std::size_t count, double time, glm::vec3* out) const override;
    WindFieldPtr withoutGusts() const override;

    const WindFieldPtr& inner() const { return _inner; } ///< Never null.
    const Adjustment& adjustment() const { return _adjustment; }

private:
    WindFieldPtr _inner;
    Adjustment _adjustment;
    glm::mat3 _adjust;
};

} // namespace osgTreeWind
