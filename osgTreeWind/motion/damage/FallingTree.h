// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>

namespace osgTreeWind {

/// A falling tree or bough: a rigid body on a hinge, driven by its weight and by the wind that broke it,
/// which acts as long as the tree is upright, and slowed by the drag of its crown. The hinge transmits no
/// moment; a bough ends up hanging from it.
class FallingTree {
public:
    /// @param unit the tree falls about its base. @param moment of the wind at that base, N m.
    /// @param lean of its top at failure, relative to rest, radians.
    FallingTree(const TreeForm& tree, unsigned unit, double moment, double lean);

    /// For a bough: the horizontal axis, in the tree's own axes, about which it swings down.
    const glm::vec2& axis() const { return _axis; }

    void step(double seconds);
    double angle() const { return _angle; } ///< Since failure, radians.
    double speed() const { return _speed; } ///< rad/s
    /// Final angle, at which the crown lies on level ground or a bough hangs, radians.
    double restAngle() const { return _rest; }
    /// Remaining share of the tree's sway, 1 to 0.
    double swayShare() const;
    bool isAtRest() const { return _angle >= _rest; } ///< Whether it has come to rest.

private:
    double _weight = 0.0, _push = 0.0, _drag = 0.0; ///< Per inertia about the hinge: 1/s^2, 1/s^2, 1.
    double _lean, _rest = 0.0, _angle = 0.0, _speed = 0.0;
    glm::vec2 _axis{0.0f, 1.0f};
};

} // namespace osgTreeWind
