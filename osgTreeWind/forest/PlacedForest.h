// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/forest/TreeNames.h>
#include <osgTreeWind/model/MeasureTree.h>

#include <functional>
#include <memory>
#include <set>

namespace osgTreeWind {

class ShapeFamilies;

/// Shapes by index; none is null.
using SharedModels = std::vector<std::shared_ptr<const TreeModel>>;

/// A tree where it stands.
struct PlacedTree {
    std::uint32_t model = 0;   ///< Index into PlacedForest::models().
    std::uint32_t species = 0; ///< Index into the description's.
    TreeScale scale;           ///< Of the model.
    glm::vec3 position{0.0f};  ///< Scene coordinates.
    float heading = 0.0f;      ///< Radians, counterclockwise from above.
    float leaves = 1.0f;       ///< Share that it bears now,
    float summerLeaves = 1.0f; ///< and in summer.
    std::uint32_t seed = 0;    ///< Picks its shape, and what is at random in its motion.
    // For the laws of a branch; 0 in a tree that was added later.
    std::uint32_t firstUnit = 0;  ///< Units of all trees before it.
    std::uint32_t firstLeaf = 0;  ///< Leaf clusters of all trees before it.
    std::uint32_t generation = 0; ///< Trees that stood in this slot before it.
    bool alive = true;            ///< No: it was removed, and nothing else here counts.
    bool openGrown = false;       ///< In the open (TreePlacement::openGrown).
    bool atEdge = false;          ///< TreePlacement::atEdge.
    bool tiled = false;           ///< TreePlacement::tiled.
    EstimatedSizes estimated;     ///< Of `given`.
    TreeSize given;               ///< From which, with openGrown, `scale` follows.
};

/// A forest at rest: its shapes grown, its trees placed. A copy shares the shapes. Read by many threads while
/// none writes.
struct PlacedForest {
    /// @param given for which check() finds nothing. @param placed called after each tree; may be empty.
    /// @param executor grows its shapes; none: the threads of the process.
    explicit PlacedForest(ForestDescription given, const std::function<void()>& placed = {},
                          const Executor& executor = {});

    std::vector<PlacedTree> trees; ///< By slot: in the order of the description, then as they were added.
    std::size_t units = 0;         ///< Of the description's trees,
    std::size_t leaves = 0;        ///< and their leaf clusters.
    TreeNames names;               ///< That trees have, by slot.

    /// As given, but without its trees, and with its first season. Stays where it is until addSpecies().
    const ForestDescription& description() const { return *_description; }
    /// Shapes, shared by trees and by forests.
    const SharedModels& models() const { return _models; }
    /// Grows the shapes of one more species, for which check() finds nothing. @param executor as above.
    /// @return its index.
    std::size_t addSpecies(Species species, const Executor& executor = {});

    /// Its shape.
    const TreeModel& modelOf(const PlacedTree& tree) const { return *_models[tree.model]; }
    /// Its species, which stays where it is as long as this or a copy lives.
    const Species& speciesOf(const PlacedTree& tree) const { return *_species[tree.species]; }
    /// Of which species a model is a shape.
    std::size_t speciesOfModel(std::size_t model) const;
    /// How many it has.
    std::size_t unitsOf(const PlacedTree& tree) const { return modelOf(tree).skeleton.units.size(); }
    /// How many clusters it has.
    std::size_t leavesOf(const PlacedTree& tree) const { return modelOf(tree).leaves.size(); }

    /// A tree for which check() finds nothing, as it would stand. Of a species whose trees all stood in a
    /// forest, or all in the open, as the forest was made, it takes their shapes. The scale of `before` is
    /// kept where the placement gives its model and measured sizes.
    PlacedTree fitted(const TreePlacement& placement, const PlacedTree* before = nullptr) const;
    /// Its sizes as it stands.
    TreeSize measured(const PlacedTree& tree) const { return measureTree(modelOf(tree), tree.scale); }
    /// What gives that tree again; all of its sizes are given.
    TreePlacement placementOf(std::size_t slot) const;
    /// The forest as it is by now, but for its wind: what gives it again, with the trees that are alive by
    /// slot and the sizes they were given. Not what any file says: without a source.
    ForestDescription describe() const;
    /// Of the year, as it is by now (Season.h).
    float season() const { return _season; }
    /// Has all trees bear the leaves they bear then.
    void setSeason(float season);

    /// Puts a tree into a slot, at most trees.size(), instead of the one that stands or stood there.
    void put(std::size_t slot, PlacedTree tree, const std::string& name);
    /// The tree in a slot is there no more, and its id is of none.
    void remove(std::size_t slot);
    /// Has the tree of a tile not come again, once it is gone. Others are none of its business.
    void strike(std::size_t slot);
    /// ForestTiles::removed, as it is by now.
    const std::set<std::string>& struck() const { return _struck; }

    bool holds(TreeId id) const; ///< Whether that tree is there.
    /// Of the tree in a slot.
    TreeId idOf(std::size_t slot) const { return makeTreeId(slot, trees[slot].generation); }

private:
    void growShapes(const Executor& executor);

    std::shared_ptr<const ForestDescription> _description;
    SharedModels _models;
    std::vector<std::shared_ptr<const Species>> _species; ///< The description's.
    std::shared_ptr<const ShapeFamilies> _families;
    std::vector<std::uint32_t> _firstModels; ///< Per family.
    float _season = midsummer;
    std::vector<float> _seasonLeaves; ///< Per species, share of what its trees bear in summer.
    std::set<std::string> _struck;
};

/// v turned counter-clockwise about the vertical.
glm::vec3 turnHeading(const glm::vec3& v, float sine, float cosine);

} // namespace osgTreeWind
