// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// Names of those trees that have one, no two alike, as an inventory gives them. Takes no memory where none
/// has.
class TreeNames {
public:
    TreeNames() = default;
    TreeNames(const TreeNames& other) { *this = other; } ///< All names.
    TreeNames& operator=(const TreeNames& other);        ///< All names.

    /// Gives the tree in a slot that name instead of its own; empty: none. @return false where another tree
    /// has it: then this one has none.
    bool set(std::uint32_t slot, const std::string& name);
    std::optional<std::uint32_t> find(const std::string& name) const; ///< Nothing: none has it.
    /// Empty for none.
    std::string of(std::uint32_t slot) const;

private:
    std::unordered_map<std::string, std::uint32_t> _slots;
    std::vector<const std::string*> _names; ///< By slot, keys of `_slots`; may end before the last slot.
};

} // namespace osgTreeWind
