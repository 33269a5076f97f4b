// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <glm/vec4.hpp>

#include <vector>

namespace osgTreeWind {

// What the angle passes work with, as texels: the counterpart of shaders/branchwise/branch_angles.frag and
// leaf_angles.frag. Not for installed headers, as motion/laws/Laws.h.

/// Three texels a unit: what it is to the laws; in the last one the species, the seed of its tree in two
/// halves, and its index in the tree.
std::vector<glm::vec4> branchTexels(const PlacedForest& forest, const BranchwiseMotion& branches);
/// One texel a leaf cluster: species, seed of its tree in two halves, index in its tree.
std::vector<glm::vec4> leafTexels(const PlacedForest& forest);

/// Four texels a species: NoiseTime of branches and of leaves (cell in two halves, fraction, gain), leaf
/// motion. @param time seconds.
std::vector<glm::vec4> speciesTexels(const ForestDescription& description, double time);

} // namespace osgTreeWind
