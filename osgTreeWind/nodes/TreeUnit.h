// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>

#include <osg/Vec3>

#include <optional>
#include <vector>

namespace osgTreeWind {

/// A branch unit of one tree: the wood from one fork to the next. docs/coordinates.md says what the frames
/// are.
struct TreeUnit {
    int parent = -1;         ///< Index of the unit that carries it; -1: the ground.
    int level = 0;           ///< 0 for the trunk, one more at each fork.
    float baseRadius = 0.0f; ///< Metres.
    float tipRadius = 0.0f;  ///< Metres.
    osg::Vec3 restBase;      ///< At rest, in the tree's frame, as what hangs on it stands.
    osg::Vec3 restTip;       ///< Likewise.
    osg::Vec3 base;          ///< Now, in the forest's frame.
    osg::Vec3 tip;           ///< Likewise.
};

/// Index of the unit whose line from base to tip passes nearest to a point of the forest's frame now; nothing
/// where there are no units.
OSGTREEWIND_EXPORT std::optional<unsigned> nearestUnit(const std::vector<TreeUnit>& units,
                                                       const osg::Vec3& point);

} // namespace osgTreeWind
