// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/ModalLevel.h>

#include <glm/vec3.hpp>

namespace osgTreeWind {

/// A tree under the law `modal`, and where it stands.
struct ModalTree {
    SwayingTree form;
    glm::vec3 foot{0.0f};                ///< Scene coordinates, metres.
    float heading = 0.0f;                ///< Radians, counter-clockwise from above.
    ModalLevel level = ModalLevel::Near; ///< At first.
};

} // namespace osgTreeWind
