// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/JointTree.h>
#include <osgTreeWind/motion/ModalShape.h>

namespace osgTreeWind {

/// A tree that leans moves at height z by its lean times (z / height)^leanPower: what comes nearest to the
/// crowns of the built-in species (tests/motion/ModalLeanTest.cpp).
constexpr float leanPower = 1.5f;

/// Per mode of `shape`, how far the top of a leaning tree moves by its amplitude, x and y in metres: least
/// squares over the tree's drag, which is where its crown is. @param height of the whole tree.
std::vector<glm::vec2> modalLeans(const JointTree& tree, const ModalShape& shape, double height,
                                  double power = static_cast<double>(leanPower));

} // namespace osgTreeWind
