// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <osg/Vec3>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// A branch unit of a tree: the wood between two forks. Metres, in the frames of docs/coordinates.md.
struct TreeUnit {
    int parent = -1; ///< Index of the unit that carries this one; -1: none, as it stands on the ground.
    int level = 0;   ///< 0 for the trunk; one more at each fork.
    float baseRadius = 0.0f; ///< Radius at the base.
    float tipRadius = 0.0f;  ///< Radius at the tip.
    osg::Vec3 restBase;      ///< Base at rest, in the tree's frame, as children of a BranchTransform use it.
    osg::Vec3 restTip;       ///< Tip at rest, in the tree's frame.
    osg::Vec3 base;          ///< Base now, in the forest's frame.
    osg::Vec3 tip;           ///< Tip now, in the forest's frame.
};

/// Returns the index of the unit nearest to a point, by the distance to its axis now; empty without units.
/// @param point in the forest's frame, metres.
OSGTREEWIND_EXPORT std::optional<unsigned> nearestUnit(const std::vector<TreeUnit>& units,
                                                       const osg::Vec3& point);

} // namespace osgTreeWind
