// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace osgTreeWind {

/// Identifies a tree for the lifetime of its forest: its slot (low 32 bits), and the number of earlier trees
/// in that slot (high 32 bits). The id of a removed tree stays invalid. Slots are std::size_t.
enum class TreeId : std::uint64_t {};

/// An id that is never valid.
constexpr TreeId noTree = TreeId(~std::uint64_t(0));

constexpr TreeId makeTreeId(std::size_t slot, std::uint32_t generation) {
    return TreeId(std::uint64_t(generation) << 32 | static_cast<std::uint32_t>(slot));
}
constexpr std::size_t slotOfTree(TreeId id) {
    return static_cast<std::uint32_t>(id);
}

} // namespace osgTreeWind
