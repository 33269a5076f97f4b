// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalMotion.h>

namespace osgTreeWind {

/// The moment of a tree's weight, inertia and the air on what holds its trunk to the ground: K theta there.
class FootMoment {
public:
    explicit FootMoment(const SwayingTree& tree);

    /// Of that tree as it sways now, N m. @param tree its number in `motion`.
    double of(const ModalMotion& motion, std::size_t tree) const;

private:
    std::size_t _unit = 0; ///< The first of the trunk.
    double _stiffness = 0.0;
};

} // namespace osgTreeWind
