// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace osgTreeWind {

/// Names a tree for as long as its forest lives: which slot it stands in (low 32 bits), and how many trees
/// stood there before it (high 32 bits). A tree that was removed leaves an id that names none.
using TreeId = std::uint64_t;

/// Names no tree of any forest.
constexpr TreeId noTree = ~TreeId(0);

constexpr TreeId makeTreeId(std::size_t slot, std::uint32_t generation) {
    return static_cast<TreeId>(generation) << 32 | static_cast<std::uint32_t>(slot);
}
constexpr std::size_t slotOfTree(TreeId id) {
    return static_cast<std::uint32_t>(id);
}

} // namespace osgTreeWind
