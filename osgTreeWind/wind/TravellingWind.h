// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/WindField.h>

namespace osgTreeWind {

/// A wind known over time at a plane x = `plane`, carried east unchanged (Taylor's frozen turbulence): at x
/// and t it is the inner wind of the time when that air passed the plane, t - (x - plane) / speed.
class TravellingWind final : public WindField {
public:
    /// @param inner not null.
    /// @param plane scene x of the plane, metres.
    /// @param speed m/s toward +x, not 0.
    TravellingWind(WindFieldPtr inner, double plane, double speed);

    glm::vec3 velocity(const glm::vec3& position, double time) const override;

private:
    WindFieldPtr _inner;
    double _plane;
    double _speed;
};

} // namespace osgTreeWind
