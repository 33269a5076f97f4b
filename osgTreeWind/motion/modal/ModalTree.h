// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>

#include <glm/vec3.hpp>

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

} // namespace osgTreeWind
