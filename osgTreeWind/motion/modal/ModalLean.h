// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/motion/modal/ModalModel.h>

namespace osgTreeWind {

/// Exponent of a leaning tree's shape: height z moves by lean times (z / height)^leanPower. Best compromise
/// for the built-in species (1.5 suits spruces, 2.5 broadleaves): the middle of a crown is within 7 % of its
/// displacement, half of them within 2 %; single leaf clusters within 7 to 47 %, half within 26 %.
constexpr float leanPower = 1.75f;

/// Displacement of the treetop per amplitude of each mode, x and y, metres. It is chosen so that the middle
/// of the crown (of the leaf clusters or, without leaves, of the unit tips) moves as the real one, including
/// the deflection of a steady wind that the modes leave out.
/// @param joints of the same model and scale.
std::vector<glm::vec2> modalLeans(const TreeModel& model, const TreeScale& scale, const JointTree& joints,
                                  const ModalModel& modal);

} // namespace osgTreeWind
