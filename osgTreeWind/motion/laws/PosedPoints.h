// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/UnitPose.h>

namespace osgTreeWind {

/// Posed position of a bark vertex, in the tree's frame. @param pose of the vertex's unit.
inline glm::vec3 posedSkinPoint(const SkinVertex& vertex, const TreeScale& scale, const UnitPose& pose) {
    return pose.apply(scale.axes * vertex.centre + scale.radius * vertex.radius * vertex.outward);
}

/// Posed position of a corner of a leaf cluster, in the tree's frame. @param turn rotation from the leaf
/// frame to the tree's rest axes, including flutter. @param pose of the cluster's unit.
inline glm::vec3 posedLeafPoint(const LeafCluster& leaf, const glm::vec3& corner, const glm::quat& turn,
                                const TreeScale& scale, const UnitPose& pose) {
    return pose.apply(scale.axes * leaf.anchor + turn * (scale.leaf * leaf.size * corner));
}

} // namespace osgTreeWind
