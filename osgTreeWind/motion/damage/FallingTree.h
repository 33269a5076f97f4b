// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>

namespace osgTreeWind {

/// A tree or a bough on its way down: a rigid body on a hinge, under its weight, the wind that broke it,
/// which blows on as long as it stands in it, and the drag of its crown. Roots and wood hold nothing any more
/// but the hinge: a bough comes to hang from it.
class FallingTree {
public:
    /// @param unit about whose base it falls. @param moment of the wind at that base, N m.
    /// @param lean of its top, radians, when it fails, beyond how it stands at rest.
    FallingTree(const SwayingTree& tree, unsigned unit, double moment, double lean);

    /// The level axis about which it falls when it falls the way it lies at rest, in the tree's own axes; of
    /// a bough.
    const glm::vec2& axis() const { return _axis; }

    /// Moves on by that many seconds.
    void step(double seconds);
    /// From how it stood when it failed, radians.
    double angle() const { return _angle; }
    double speed() const { return _speed; } ///< rad/s
    /// That at which its crown lies on level ground, or a bough hangs.
    double restAngle() const { return _rest; }
    /// Share of its sway that is left, 1 to 0.
    double sway() const;
    bool lies() const { return _angle >= _rest; }

private:
    double _weight = 0.0, _push = 0.0, _drag = 0.0; ///< Over its inertia about the hinge: 1/s^2, 1/s^2, 1.
    double _lean, _rest = 0.0, _angle = 0.0, _speed = 0.0;
    glm::vec2 _axis{0.0f, 1.0f};
};

} // namespace osgTreeWind
