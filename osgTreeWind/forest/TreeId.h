// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace osgTreeWind {

/// Names a tree for as long as its forest lives: which slot it stands in (low 32 bits), and how many trees
/// stood there before it (high 32 bits). A tree that was removed leaves an id that names none.
/// Nothing but an id is one: a slot, the place of a tree in lists, is a std::size_t.
enum class TreeId : std::uint64_t {};

/// Names no tree of any forest.
constexpr TreeId noTree = TreeId(~std::uint64_t(0));

constexpr TreeId makeTreeId(std::size_t slot, std::uint32_t generation) {
    return TreeId(std::uint64_t(generation) << 32 | static_cast<std::uint32_t>(slot));
}
constexpr std::size_t slotOfTree(TreeId id) {
    return static_cast<std::uint32_t>(id);
}

} // namespace osgTreeWind
