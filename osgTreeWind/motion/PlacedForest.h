// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/ForestDescription.h>

namespace osgTreeWind {

/// A tree where it stands.
struct PlacedTree {
    std::size_t model = 0; ///< Index into PlacedForest::models.
    std::size_t species = 0;
    TreeScale scale;
    glm::vec3 position{0.0f}; ///< Scene coordinates.
    float heading = 0.0f;
    float leaves = 1.0f;
    std::uint32_t seed = 0;
    std::size_t firstUnit = 0; ///< Units of all trees before it.
    std::size_t firstLeaf = 0; ///< Leaf clusters of all trees before it.
};

/// A forest at rest: its shapes grown, its trees placed.
struct PlacedForest {
    /// Trees of a species that is not there are left out.
    explicit PlacedForest(ForestDescription given);

    ForestDescription description; ///< As given, but for trees left out.
    std::vector<TreeModel> models;
    std::vector<PlacedTree> trees; ///< In the order of the description.
    std::size_t units = 0, leaves = 0;

    const TreeModel& modelOf(const PlacedTree& tree) const { return models[tree.model]; }
    const Species& speciesOf(const PlacedTree& tree) const { return description.species[tree.species]; }
    std::size_t unitsOf(const PlacedTree& tree) const { return modelOf(tree).skeleton.units.size(); }
    std::size_t leavesOf(const PlacedTree& tree) const { return modelOf(tree).leaves.size(); }
};

/// v turned counter-clockwise about the vertical.
glm::vec3 turnHeading(const glm::vec3& v, float sine, float cosine);

} // namespace osgTreeWind
