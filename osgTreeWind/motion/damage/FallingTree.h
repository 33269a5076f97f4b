// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>

namespace osgTreeWind {

/// A tree on its way down: a rigid body on a hinge, under its weight, the wind that broke it, which blows on
/// as long as the crown stands in it, and the drag of the crown. Roots and wood hold nothing any more.
class FallingTree {
public:
    /// @param unit of its trunk, about whose base it falls. @param moment of the wind at that base, N m.
    /// @param lean of its top, radians, when it fails.
    FallingTree(const SwayingTree& tree, unsigned unit, double moment, double lean);

    /// Moves on by that many seconds.
    void step(double seconds);
    /// From how it stood when it failed, radians.
    double angle() const { return _angle; }
    double speed() const { return _speed; } ///< rad/s
    /// That at which its crown lies on level ground.
    double restAngle() const { return _rest; }
    /// Share of its sway that is left, 1 to 0.
    double sway() const;
    bool lies() const { return _angle >= _rest; }

private:
    double _weight = 0.0, _push = 0.0, _drag = 0.0; ///< Over its inertia about the hinge: 1/s^2, 1/s^2, 1.
    double _lean, _rest, _angle = 0.0, _speed = 0.0;
};

} // namespace osgTreeWind
