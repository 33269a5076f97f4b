// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/TreeFall.h>
#include <osgTreeWind/wind/PlaceInStand.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// Trees of one archetype at one level.
struct ModalGroup {
    static constexpr std::size_t lanes = TreeLanes::count;
    /// Floats of TreeFactors, the last of a tree's numbers.
    static constexpr std::size_t factorCount = sizeof(TreeFactors) / sizeof(float);

    const Archetype* archetype;
    std::size_t level;
    std::vector<TreeLanes> numbers;   ///< Block after block (treeFloats()).
    std::vector<std::uint32_t> trees; ///< Tree at each place.
    std::vector<float> waiting;       ///< Per block, seconds since the time of its last step.
    std::vector<PlaceInStand> stands; ///< WindPlace::stand per tree and patch; empty where no trees shelter.

    ModalGroup(const Archetype& a, std::size_t l) : archetype(&a), level(l) {}

    const ModalModel& model() const { return archetype->model(level); }
    std::size_t firstFactor() const { return treeFloats(model()) - factorCount; }

    std::size_t treesIn(std::size_t block) const { return std::min(lanes, trees.size() - block * lanes); }
    TreeLanes* block(std::size_t index) { return numbers.data() + index * treeFloats(model()); }
    const TreeLanes* block(std::size_t index) const { return numbers.data() + index * treeFloats(model()); }
    float& number(std::size_t place, std::size_t index) {
        return block(place / lanes)[index].tree[place % lanes];
    }
    float number(std::size_t place, std::size_t index) const {
        return block(place / lanes)[index].tree[place % lanes];
    }

    /// Reserves memory for exactly that many trees.
    void reserve(std::size_t count);
    /// Appends a tree at rest. @return its place.
    std::size_t add(std::uint32_t tree);
    /// Moves the last tree to this place.
    void remove(std::size_t place);
    /// Makes `stands` for all trees, or removes it.
    void keepStands(bool keep) {
        stands.resize(keep ? trees.size() * model().patches.size() : 0);
        if (!keep)
            stands.shrink_to_fit();
    }
};

/// State of all trees under the law `modal`. A tree is identified by its number.
struct ModalState {
    /// Group of a tree (~0: none) and its place in the group.
    struct Slot {
        std::uint32_t group = ~0u, place = 0;
    };
    struct Place {
        glm::vec3 foot{0.0f};
        float width = 1.0f; ///< Horizontal lengths relative to the archetype's.
    };
    /// A block to be stepped to `time`.
    struct Work {
        std::uint32_t group, block;
        float seconds;
        double time;
    };

    float gain = 1.0f;                                 ///< [0, 100]
    std::vector<ModalGroup> groups;                    ///< One per archetype and level.
    std::vector<Slot> slots;                           ///< Per tree.
    std::vector<Place> places;                         ///< Per tree.
    std::vector<glm::vec2> leans;                      ///< Per tree: ModalMotion::lean().
    std::unordered_map<std::uint32_t, TreeFall> falls; ///< Trees with fallen parts.
    std::vector<Work> work;                            ///< Blocks of the current step.

    /// Sets the number of trees; new ones belong to no group.
    void resize(std::size_t trees);
    void addToGroup(std::size_t tree, std::size_t group); ///< At rest in calm.
    void removeFromGroup(std::size_t tree);               ///< Out of its group.
    const ModalGroup& groupOf(std::size_t tree) const { return groups[slots[tree].group]; }
    float& number(std::size_t tree, std::size_t index) {
        return groups[slots[tree].group].number(slots[tree].place, index);
    }
    float number(std::size_t tree, std::size_t index) const {
        return groupOf(tree).number(slots[tree].place, index);
    }
    TreeFactors factors(std::size_t tree) const;
    void setFactors(std::size_t tree, const TreeFactors& factors);
    const TreeFall* fall(std::size_t tree) const; ///< Null: the tree is whole.
    /// Remaining share of the tree's sway.
    float swayShare(std::size_t tree) const { return fall(tree) ? fall(tree)->sway : 1.0f; }
    /// Updates the lean from the modal amplitudes.
    void updateLean(std::size_t tree);
    /// Back to rest, in calm.
    void reset();
    std::size_t bytes() const;
};

} // namespace osgTreeWind
