// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/ScannedTree.h>
#include <osgTreeWind/model/WoodAxis.h>

#include <vector>

namespace osgTreeWind {

/// What became of axes.
struct SkeletonOfAxes {
    Skeleton skeleton;      ///< Joined.
    std::size_t pieces = 0; ///< Of the axes that are in it.
};

/// The skeleton of a tree's axes, the trunk first and parents before their branches: units and shoots as
/// makeScannedTree() says.
SkeletonOfAxes makeSkeleton(std::vector<WoodAxis> axes, const WoodDetail& detail);

} // namespace osgTreeWind
