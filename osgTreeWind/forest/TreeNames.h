// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// A two-way map between slots and unique names of trees, such as ids of an inventory. Trees without a name
/// need no memory if no tree has one.
class TreeNames {
public:
    TreeNames() = default;
    TreeNames(const TreeNames& other) { *this = other; }
    TreeNames& operator=(const TreeNames& other);

    /// Sets or, with an empty name, clears the name of a tree. @return false, and unnames it, if another tree
    /// has that name.
    bool set(std::uint32_t slot, const std::string& name);
    std::optional<std::uint32_t> find(const std::string& name) const; ///< The slot of the tree.
    std::string of(std::uint32_t slot) const;                         ///< The name; empty if it has none.

private:
    std::unordered_map<std::string, std::uint32_t> _slots;
    std::vector<const std::string*> _names; ///< Keys of `_slots` by slot; may be shorter than the forest.
};

} // namespace osgTreeWind
