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

/// One tree as it stands now: its model, its size, and where its units and leaves are. Shared by the nodes
/// that draw it. Not thread-safe: changed in the update traversal only.
class PosedTree : public osg::Referenced {
public:
    PosedTree(std::shared_ptr<const TreeModel> model, const TreeScale& scale);

    const TreeModel& model() const { return *_model; }
    const TreeScale& scale() const { return _scale; }

    /// The motion the tree follows; nothing stands for rest.
    /// @param motion must outlive this object, or be kept alive by `owner`.
    void follow(std::shared_ptr<const void> owner, const TreeMotion& motion);

    UnitPose pose(std::size_t unit) const { return _motion.poses.data ? _motion.poses[unit] : UnitPose(); }
    glm::quat rotation(std::size_t unit) const {
        return _motion.rotations.data ? _motion.rotations[unit] : glm::quat(1.0f, 0.0f, 0.0f, 0.0f);
    }
    /// A vertex of the bark, in the tree's frame; `pose` of its unit.
    glm::vec3 skinPoint(const SkinVertex& vertex, const UnitPose& pose) const;
    /// From the leaf frame of a cluster to the tree's rest axes, as it flutters now.
    glm::quat leafTurn(std::size_t leaf) const;
    /// The twelve corners of a leaf cluster, in the tree's frame.
    void leafPoints(std::size_t leaf, glm::vec3* corners) const;

    /// Everything the tree has covered so far, in its own frame.
    const osg::BoundingBox& bounds() const { return _bounds; }
    /// Takes the current pose into bounds(). @return whether they grew.
    bool growBounds();

private:
    std::shared_ptr<const TreeModel> _model;
    TreeScale _scale;
    std::shared_ptr<const void> _owner;
    TreeMotion _motion;
    float _reach = 0.0f; // of leaves and bark from the centre line
    osg::BoundingBox _bounds;
};

} // namespace osgTreeWind
