// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/TreeFall.h>

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
    /// Floats of a TreeFactors, which end a tree's numbers.
    static constexpr std::size_t factorCount = sizeof(TreeFactors) / sizeof(float);

    const Archetype* archetype;
    std::size_t level;
    std::vector<TreeLanes> numbers;   ///< Block after block (treeFloats()).
    std::vector<std::uint32_t> trees; ///< Which tree is at each place.
    std::vector<float> waiting;       ///< Per block, seconds since the time it was stepped to.

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

    /// Room for that many trees and no more.
    void reserve(std::size_t count);
    /// At the end, at rest. @return its place.
    std::size_t add(std::uint32_t tree);
    /// The last one takes its place.
    void remove(std::size_t place);
};

/// All that changes as trees sway under the law `modal`. A tree has a number, by which it is known here.
struct ModalState {
    /// Where a tree is: its group, ~0 for none, and its place there.
    struct Slot {
        std::uint32_t group = ~0u, place = 0;
    };
    struct Place {
        glm::vec3 foot{0.0f};
        float width = 1.0f; ///< Lengths across over its archetype's.
    };
    /// A block to be stepped, to a time.
    struct Work {
        std::uint32_t group, block;
        float seconds;
        double time;
    };

    float gain = 1.0f;                                 ///< [0, 100]
    std::vector<ModalGroup> groups;                    ///< Two for each archetype, one a level.
    std::vector<Slot> slots;                           ///< Per tree,
    std::vector<Place> places;                         ///< per tree
    std::vector<glm::vec2> leans;                      ///< and per tree: ModalReader::lean().
    std::unordered_map<std::uint32_t, TreeFall> falls; ///< Of trees of which something has come down.
    std::vector<Work> work;                            ///< Of the step at hand.

    /// Makes room for so many trees, without a place.
    void resize(std::size_t trees);
    void put(std::size_t tree, std::size_t group); ///< At rest in a calm.
    void take(std::size_t tree);                   ///< Out of its group.
    const ModalGroup& groupOf(std::size_t tree) const { return groups[slots[tree].group]; }
    float& number(std::size_t tree, std::size_t index) {
        return groups[slots[tree].group].number(slots[tree].place, index);
    }
    float number(std::size_t tree, std::size_t index) const {
        return groupOf(tree).number(slots[tree].place, index);
    }
    TreeFactors factors(std::size_t tree) const;
    void setFactors(std::size_t tree, const TreeFactors& factors);
    const TreeFall* fall(std::size_t tree) const; ///< Null: it stands.
    /// The share of its sway that is left to a tree.
    float shareOfSway(std::size_t tree) const { return fall(tree) ? fall(tree)->sway : 1.0f; }
    /// Works out the lean of a tree as its modes are by now.
    void refreshLean(std::size_t tree);
    /// Back to rest, in a calm.
    void reset();
    std::size_t bytes() const;
};

} // namespace osgTreeWind
