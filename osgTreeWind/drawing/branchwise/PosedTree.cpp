// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/branchwise/PosedTree.h>

#include <osgTreeWind/motion/laws/PosedPoints.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>

namespace osgTreeWind {

PosedTree::PosedTree(std::shared_ptr<const TreeModel> model, const TreeScale& scale)
    : _model(std::move(model)), _scale(scale) {
    float corner = 0.0f, size = 0.0f, radius = 0.0f, offset = 0.0f;
    for (const LeafVertex& vertex : _model->leafMesh)
        corner = std::max(corner, glm::length(vertex.corner));
    for (const LeafCluster& leaf : _model->leaves)
        size = std::max(size, leaf.size);
    for (const SkinVertex& vertex : _model->skin().vertices)
        radius = std::max(radius, vertex.radius);
    const Skeleton& skeleton = _model->skeleton;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit) {
        for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring) {
            const float t = static_cast<float>(ring) / static_cast<float>(skeleton.ringsPerBranch - 1);
            const glm::vec3 straight = glm::mix(skeleton.units[unit].base, skeleton.units[unit].tip, t);
            offset = std::max(offset, glm::distance(skeleton.point(unit, ring), straight));
        }
    }
    const float stretch = std::max({_scale.axes.x, _scale.axes.y, _scale.axes.z});
    _reach = std::max(corner * size * _scale.leaf, radius * _scale.radius) + offset * stretch;
    growBounds();
}

void PosedTree::setMotion(std::shared_ptr<const void> owner, const TreeMotion& motion) {
    _owner = std::move(owner);
    _motion = motion;
}

glm::vec3 PosedTree::skinPoint(const SkinVertex& vertex, const UnitPose& pose) const {
    return posedSkinPoint(vertex, _scale, pose);
}

glm::quat PosedTree::leafOrientation(std::size_t leaf) const {
    const glm::quat& rest = _model->leaves[leaf].orientation;
    return _motion.leaves.data ? rest * leafRotation(_motion.leaves[leaf]) : rest;
}

void PosedTree::leafPoints(std::size_t leaf, glm::vec3* corners) const {
    const LeafCluster& cluster = _model->leaves[leaf];
    const glm::quat turn = leafOrientation(leaf);
    const UnitPose unitPose = pose(static_cast<std::size_t>(cluster.unit));
    for (std::size_t i = 0; i < verticesPerLeafCluster; ++i)
        corners[i] = posedLeafPoint(cluster, _model->leafMesh[i].corner, turn, _scale, unitPose);
}

bool PosedTree::growBounds() {
    glm::vec3 low(0.0f), high(0.0f);
    const std::vector<BranchUnit>& units = _model->skeleton.units;
    for (std::size_t unit = 0; unit < units.size(); ++unit) {
        const glm::vec3 tip = pose(unit).apply(_scale.axes * units[unit].tip);
        low = glm::min(low, tip);
        high = glm::max(high, tip);
    }
    osg::BoundingBox now(toOsg(low - _reach), toOsg(high + _reach));
    if (_bounds.valid() && _bounds.contains(now._min) && _bounds.contains(now._max))
        return false;
    // The margin makes the bounds settle after a few frames.
    const osg::Vec3 room = _bounds.valid() ? (now._max - now._min) * 0.05f : osg::Vec3();
    _bounds.expandBy(now._min - room);
    _bounds.expandBy(now._max + room);
    return true;
}

} // namespace osgTreeWind
