// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/modal/Archetype.h>

#include <cstdint>

namespace osgTreeWind {

/// Level of detail at which the law `modal` simulates a tree.
enum class ModalLevel : std::uint8_t {
    Near, ///< Up to 12 modes, 12 patches, every step.
    Far   ///< Up to 4 modes, 4 patches, a step each fifth of a second (ModalStepJob::farStep).
};

/// A tree under the law `modal` and its position.
struct ModalTree {
    TreeForm form;
    glm::vec3 foot{0.0f};                ///< Scene coordinates, metres.
    float heading = 0.0f;                ///< Radians, counter-clockwise from above.
    ModalLevel level = ModalLevel::Near; ///< Initial level.
};

/// The modal input of a placed tree.
inline ModalTree makeModalTree(const PlacedForest& forest, const PlacedTree& tree,
                               ModalLevel level = ModalLevel::Near) {
    return {{&forest.modelOf(tree), &forest.speciesOf(tree), tree.scale, tree.leaves},
            tree.position,
            tree.heading,
            level};
}

} // namespace osgTreeWind
