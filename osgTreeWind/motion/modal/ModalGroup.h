// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/RoomFor.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace osgTreeWind {

// Parts of ModalMotion; not installed.

/// Floats of a TreeFactors, which end a tree's numbers.
constexpr std::size_t factorCount = sizeof(TreeFactors) / sizeof(float);

/// Where a tree is: its group, ~0 for none, and its place there.
struct ModalMotion::Slot {
    std::uint32_t group = ~0u, place = 0;
};

struct ModalMotion::Place {
    glm::vec3 foot{0.0f};
    float width = 1.0f; ///< Lengths across over its archetype's.
};

/// A block to be stepped, to a time.
struct ModalMotion::Work {
    std::uint32_t group, block;
    float seconds;
    double time;
};

/// Trees of one archetype at one level.
struct ModalMotion::Group {
    static constexpr std::size_t lanes = TreeLanes::count;

    const Archetype* archetype = nullptr;
    std::size_t level = 0;
    std::vector<TreeLanes> numbers;   ///< Block after block.
    std::vector<std::uint32_t> trees; ///< Which tree is at each place.
    std::vector<float> waiting;       ///< Per block, seconds since the time it was stepped to.

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

    /// All of a tree but its factors; what it does not have is 0.
    using Numbers = std::array<float, 2 * ModalDetail::maxModes + 3 * ModalDetail::maxPatches>;
    Numbers numbersOf(std::size_t place) const;
    /// The winds at its patches from those at other ones: `patches` says which.
    void setWinds(std::size_t place, const float* winds, const std::vector<std::size_t>& patches);

    TreeFactors factors(std::size_t place) const {
        float values[factorCount];
        for (std::size_t n = 0; n < factorCount; ++n)
            values[n] = number(place, firstFactor() + n);
        TreeFactors factors;
        std::memcpy(&factors, values, sizeof values);
        return factors;
    }
    void setFactors(std::size_t place, const TreeFactors& factors) {
        float values[factorCount];
        std::memcpy(values, &factors, sizeof values);
        for (std::size_t n = 0; n < factorCount; ++n)
            number(place, firstFactor() + n) = values[n];
    }

    /// Room for that many trees and no more.
    void reserve(std::size_t count);
    /// At the end, at rest. @return its place.
    std::size_t add(std::uint32_t tree);
    /// The last one takes its place.
    void remove(std::size_t place);
};

} // namespace osgTreeWind
