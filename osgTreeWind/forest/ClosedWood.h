// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace osgTreeWind {

using TreeVisitor = std::function<void(const std::vector<TreePlacement>& trees)>;

/// Share of the ground that crowns cover in a closed wood.
constexpr double closedCover = 0.5;

/// Share of the trees that stand in a closed wood: crowns cover at least half of the ground within two tree
/// heights of them. At most 500 trees, in even steps, are looked at.
/// @param count of the trees. @param visit visits all of them in order; it is called twice.
double shareInClosedWood(const std::vector<Species>& species, std::size_t count,
                         const std::function<void(const TreeVisitor&)>& visit);

} // namespace osgTreeWind
