// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/WoodAxis.h>

#include <vector>

namespace osgTreeWind {

/// A skeleton made from axes.
struct AxesSkeleton {
    Skeleton skeleton;      ///< Joined.
    std::size_t pieces = 0; ///< Sum of WoodAxis::pieces of the axes used.
};

/// Makes a skeleton from a tree's axes, with units and shoots as described at makeScannedTree(). @param axes
/// the trunk first, parents before their branches.
AxesSkeleton makeSkeleton(std::vector<WoodAxis> axes, const WoodDetail& detail);

} // namespace osgTreeWind
