// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/instanced/TreeHit.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/instanced/TreeGeometry.h>
#include <osgTreeWind/gpu/OsgConversions.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/laws/PosedPoints.h>
#include <osgTreeWind/motion/laws/Reconfiguration.h>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

TreeHit::TreeHit(const ForestSimulation& simulation, TreeId hit) {
    const MovingForest& forest = movingForest(simulation);
    if (!simulation.holds(hit) || !forest.modal()) // under other laws, hits are on nodes
        return;
    _tree = hit;
    const std::size_t slot = slotOfTree(hit);
    const PlacedTree& tree = forest.trees()[slot];
    const TreeModel& model = forest.placed().modelOf(tree);
    UnitValues values;
    const TreeMotion motion = forest.motion(slot, values);
    const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
    const auto add = [&](const glm::vec3& point) {
        _vertices.push_back(toOsg(rotateAboutZ(point, sine, cosine) + tree.position));
    };
    for (const SkinVertex& vertex : model.skin().vertices)
        add(posedSkinPoint(vertex, tree.scale,
                           motion.poses[static_cast<std::size_t>(std::lround(vertex.unit))]));
    _indices.assign(model.skin().indices.begin(), model.skin().indices.end());
    _barkTriangles = static_cast<unsigned>(_indices.size() / 3);
    _barkEnds.assign(model.skin().firstIndices.begin() + 1, model.skin().firstIndices.end());
    if (tree.leaves <= 0.0f)
        return;
    const auto firstLeaf = static_cast<unsigned>(_vertices.size());
    for (std::size_t i = 0; i < model.leaves.size(); ++i) {
        const LeafCluster& leaf = model.leaves[i];
        const auto unit = static_cast<std::size_t>(leaf.unit);
        const glm::vec4 pull = isClusterBorne(i, tree.leaves) ? motion.pulls[unit] : noPull;
        const glm::quat turn = downwindLeafTurn(leaf.orientation, motion.leaves[i], pull);
        for (const LeafVertex& corner : model.leafMesh)
            add(posedLeafPoint(leaf, closedCorner(corner.corner, pull), turn, tree.scale,
                               motion.poses[unit]));
        _leafUnits.push_back(leaf.unit);
    }
    for (const unsigned index : leafIndices(model.leaves.size()))
        _indices.push_back(firstLeaf + index);
}

TreeHit::TreeHit(const TreeHit& other, const osg::CopyOp& copyop)
    : osg::Drawable(other, copyop), _tree(other._tree), _barkTriangles(other._barkTriangles),
      _barkEnds(other._barkEnds), _vertices(other._vertices), _indices(other._indices),
      _leafUnits(other._leafUnits) {}

unsigned TreeHit::getUnit(unsigned primitive) const {
    if (!isLeaf(primitive))
        return static_cast<unsigned>(std::upper_bound(_barkEnds.begin(), _barkEnds.end(), 3 * primitive) -
                                     _barkEnds.begin());
    const std::size_t leaf = (primitive - _barkTriangles) / trianglesPerLeafCluster;
    return leaf < _leafUnits.size() ? static_cast<unsigned>(_leafUnits[leaf]) : 0;
}

void TreeHit::accept(osg::PrimitiveFunctor& functor) const {
    functor.setVertexArray(static_cast<unsigned>(_vertices.size()), _vertices.data());
    functor.drawElements(GL_TRIANGLES, static_cast<GLsizei>(_indices.size()), _indices.data());
}

osg::BoundingBox TreeHit::computeBoundingBox() const {
    osg::BoundingBox box;
    for (const osg::Vec3& vertex : _vertices)
        box.expandBy(vertex);
    return box;
}

} // namespace osgTreeWind
