// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/BranchwiseMotion.h>

#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

// What the angle passes work with, as texels: the counterpart of shaders/branch_angles.frag and
// leaf_angles.frag.

/// Three texels a unit: the parameters of the description's law, and where its noise comes from.
std::vector<glm::vec4> branchTexels(const PlacedForest& forest, const BranchwiseMotion& branches);
/// One texel a leaf cluster: species, seed of its tree in two halves, index in its tree.
std::vector<glm::vec4> leafTexels(const PlacedForest& forest);

/// Four texels a species: NoiseTime of branches and of leaves (cell in two halves, fraction, gain), leaf
/// motion. @param time seconds.
std::vector<glm::vec4> speciesTexels(const ForestDescription& description, double time);

} // namespace osgTreeWind
