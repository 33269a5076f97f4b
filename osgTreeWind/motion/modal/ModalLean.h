// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/motion/modal/ModalModel.h>

namespace osgTreeWind {

/// A tree that leans moves at height z by its lean times (z / height)^leanPower. Of 1.5 to 2.5 this is best
/// for the built-in species together: a crown's middle is within 7 % of what it moves, half of them within 2
/// %; single clusters within 7 to 47 %, half within 26 % (1.5 suits spruces, 2.5 broadleaves).
constexpr float leanPower = 1.75f;

/// Per mode of `modal`, how far the top of a leaning tree moves by its amplitude, x and y in metres, so that
/// its crown's middle (that of its clusters of leaves, or of the tips of its units where it has none) moves
/// as the tree's own does; with what a steady wind bends beside the modes.
/// @param joints of a tree of that model and scale.
std::vector<glm::vec2> modalLeans(const TreeModel& model, const TreeScale& scale, const JointTree& joints,
                                  const ModalModel& modal);

} // namespace osgTreeWind
