// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/modal/Archetype.h>

#include <cstdint>

namespace osgTreeWind {

/// How closely the law `modal` follows a tree.
enum class ModalLevel : std::uint8_t {
    Near, ///< Up to 12 modes, 12 patches, every step.
    Far   ///< Up to 4 modes, 4 patches, a step each fifth of a second (ModalStepJob::farStep).
};

/// A tree under the law `modal`, and where it stands.
struct ModalTree {
    SwayingTree form;
    glm::vec3 foot{0.0f};                ///< Scene coordinates, metres.
    float heading = 0.0f;                ///< Radians, counter-clockwise from above.
    ModalLevel level = ModalLevel::Near; ///< At first.
};

/// A tree of a forest.
inline ModalTree swayingTree(const PlacedForest& forest, const PlacedTree& tree,
                             ModalLevel level = ModalLevel::Near) {
    return {{&forest.modelOf(tree), &forest.speciesOf(tree), tree.scale, tree.leaves},
            tree.position,
            tree.heading,
            level};
}

} // namespace osgTreeWind
