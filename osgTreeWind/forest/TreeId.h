// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// Identifies a tree for the lifetime of its forest. The first trees of a description have the ids 0, 1, 2
/// and so on. The id of a removed tree stays invalid.
enum class TreeId : std::uint64_t {};

} // namespace osgTreeWind
