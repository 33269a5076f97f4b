// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>

#include <osg/BoundingBox>
#include <osg/Referenced>

#include <memory>

namespace osgTreeWind {

/// One tree in its current pose: its model, size, and the poses of its units and leaves. Shared by the nodes
/// that draw it. Not thread-safe: changed in the update traversal only.
class PosedTree : public osg::Referenced {
public:
    PosedTree(std::shared_ptr<const TreeModel> model, const TreeScale& scale);

    const TreeModel& model() const { return *_model; }
    const TreeScale& scale() const { return _scale; }

    /// Sets where the current pose is read from. The tree is at rest until the first call.
    /// @param motion views of poses that `owner` keeps alive.
    void setMotion(std::shared_ptr<const void> owner, const TreeMotion& motion);

    UnitPose pose(std::size_t unit) const { return _motion.poses.data ? _motion.poses[unit] : UnitPose(); }
    glm::quat rotation(std::size_t unit) const {
        return _motion.rotations.data ? _motion.rotations[unit] : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    }
    /// A vertex of the bark in the tree's frame. @param pose of the unit of the vertex.
    glm::vec3 skinPoint(const SkinVertex& vertex, const UnitPose& pose) const;
    /// Rotation from the frame of a leaf cluster to the tree's rest axes, with the current flutter.
    glm::quat leafOrientation(std::size_t leaf) const;
    /// The twelve corners of a leaf cluster in the tree's frame.
    void leafPoints(std::size_t leaf, glm::vec3* corners) const;

    /// Bounds of all poses so far, in the tree's frame.
    const osg::BoundingBox& bounds() const { return _bounds; }
    /// Extends bounds() by the current pose. @return whether they grew.
    bool growBounds();

private:
    std::shared_ptr<const TreeModel> _model;
    TreeScale _scale;
    std::shared_ptr<const void> _owner;
    TreeMotion _motion;
    float _reach = 0.0f; // largest distance of leaves and bark from the straight lines of the units
    osg::BoundingBox _bounds;
};

} // namespace osgTreeWind
