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

/// Shapes by index; never null.
using SharedModels = std::vector<std::shared_ptr<const TreeModel>>;

/// The place of a tree in the arrays of its forest: the low half of its id. The high half is the number of
/// earlier trees in that slot.
constexpr std::size_t slotOfTree(TreeId id) {
    return static_cast<std::uint32_t>(id);
}
constexpr TreeId makeTreeId(std::size_t slot, std::uint32_t generation) {
    return TreeId(std::uint64_t(generation) << 32 | static_cast<std::uint32_t>(slot));
}

/// A tree of a PlacedForest: its shape, scale and position in the scene.
struct PlacedTree {
    std::uint32_t model = 0;   ///< Index into PlacedForest::models().
    std::uint32_t species = 0; ///< Index into ForestDescription::species.
    TreeScale scale;           ///< Of the model.
    glm::vec3 position{0.0f};  ///< Scene coordinates.
    float heading = 0.0f;      ///< Radians, counter-clockwise from above.
    float leaves = 1.0f;       ///< Share of its leaves in the current season.
    float summerLeaves = 1.0f; ///< Share of its leaves in summer.
    std::uint32_t seed = 0;    ///< Selects the shape and the noise streams.
    // Offsets for the thesis' laws; 0 in a tree that was added later.
    std::uint32_t firstUnit = 0;  ///< Number of units of all trees before it.
    std::uint32_t firstLeaf = 0;  ///< Number of leaf clusters of all trees before it.
    std::uint32_t generation = 0; ///< Number of earlier trees in this slot.
    bool alive = true;            ///< False: removed; all other members are meaningless.
    bool openGrown = false;       ///< TreePlacement::openGrown.
    bool atEdge = false;          ///< TreePlacement::atEdge.
    bool tiled = false;           ///< TreePlacement::tiled.
    EstimatedSizes estimated;     ///< Of `givenSize`.
    TreeSize givenSize;           ///< The size that `scale` follows from.
};

/// A forest at rest, with grown shapes and placed trees. Copies share the shapes. Threads may read it
/// concurrently while none writes.
struct PlacedForest {
    /// @param forest must pass check(). @param onTree called after each tree; may be empty.
    /// @param executor grows the shapes; empty: the thread pool of the process.
    explicit PlacedForest(ForestDescription forest, const std::function<void()>& onTree = {},
                          const Executor& executor = {});

    std::vector<PlacedTree> trees; ///< By slot: in the order of the description, then as added.
    std::size_t units = 0;         ///< Total units of the description's trees.
    std::size_t leaves = 0;        ///< Total leaf clusters of the description's trees.
    TreeNames names;               ///< Names of trees by slot.

    /// The constructor's description (also its season), without trees. Invalidated by addSpecies().
    const ForestDescription& description() const { return *_description; }
    /// All shapes, shared by trees and forests.
    const SharedModels& models() const { return _models; }
    /// Adds a species and grows its shapes. @param species must pass check(). @return its index.
    std::size_t addSpecies(Species species, const Executor& executor = {});

    const TreeModel& modelOf(const PlacedTree& tree) const { return *_models[tree.model]; }
    /// The reference is valid as long as this forest or a copy exists.
    const Species& speciesOf(const PlacedTree& tree) const { return *_species[tree.species]; }
    /// Index of the species that a model belongs to.
    std::size_t speciesOfModel(std::size_t model) const;
    std::size_t unitCount(const PlacedTree& tree) const { return modelOf(tree).skeleton.units.size(); }
    /// Number of leaf clusters.
    std::size_t leafCount(const PlacedTree& tree) const { return modelOf(tree).leaves.size(); }

    /// Selects the shape and computes the scale for a placement that passes check(). If the species had
    /// shapes for only one growing space when the forest was built, it uses those. @param previous if the
    /// placement has its size and model, its scale and given size are kept.
    PlacedTree makePlacedTree(const TreePlacement& placement, const PlacedTree* previous = nullptr) const;
    /// Size of the scaled model.
    TreeSize sizeOf(const PlacedTree& tree) const { return measureTree(modelOf(tree), tree.scale); }
    /// A placement from which makePlacedTree() makes the same tree again. It gives all sizes.
    TreePlacement placementOf(std::size_t slot) const;
    /// Describes the current forest except for its wind: with the trees that are alive, in slot order with
    /// their given sizes.
    ForestDescription currentDescription() const;
    /// Current time of year (Season.h).
    float season() const { return _season; }
    /// Sets the season, and with it the leaves of all trees.
    void setSeason(float season);

    /// The slot for another tree: that of a removed one, if there is one, else trees.size().
    std::size_t freeSlot() const { return _freeSlots.empty() ? trees.size() : _freeSlots.back(); }
    /// Puts a tree into a slot, in place of its tree, or into freeSlot().
    void put(std::size_t slot, PlacedTree tree, const std::string& name);
    /// Removes a tree and invalidates its id.
    void remove(std::size_t slot);
    /// Prevents the tree of a tile from being loaded again. No effect on trees that do not come from a tile.
    void removePermanently(std::size_t slot);
    /// Current value of ForestTiles::removed.
    const std::set<std::string>& removedPermanently() const { return _removedPermanently; }

    bool holds(TreeId id) const; ///< Whether the id names a tree of this forest.
    TreeId idOf(std::size_t slot) const { return makeTreeId(slot, trees[slot].generation); }

private:
    void growShapes(const Executor& executor);

    std::shared_ptr<const ForestDescription> _description;
    SharedModels _models;
    std::vector<std::shared_ptr<const Species>> _species; ///< Of the description.
    std::shared_ptr<const ShapeFamilies> _families;
    std::vector<std::uint32_t> _firstModels; ///< Per family.
    float _season = midsummer;
    std::vector<float> _seasonLeaves; ///< Per species, share of the summer leaves.
    std::set<std::string> _removedPermanently;
    std::vector<std::uint32_t> _freeSlots; ///< Of removed trees.
};

/// Rotates `v` counter-clockwise about the vertical.
glm::vec3 rotateAboutZ(const glm::vec3& v, float sine, float cosine);

} // namespace osgTreeWind
