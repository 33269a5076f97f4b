// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ground/GroundTile.h>

#include <osgTreeWind/gpu/EntryGuard.h>

#include <osg/CullStack>
#include <osg/NodeVisitor>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float mostPixels = 14.0f; // between vertices

} // namespace

GroundTile::GroundTile(Part part, const glm::dvec2& corner, double spacing, int levels,
                       const osg::BoundingBox& box)
    : _part(std::move(part)), _corner(corner), _spacing(spacing), _levels(levels), _box(box) {}

GroundTile::GroundTile(const GroundTile& other, const osg::CopyOp& copyop)
    : osg::Node(other, copyop), _part(other._part), _corner(other._corner), _spacing(other._spacing),
      _levels(other._levels), _box(other._box) {}

GroundTile::~GroundTile() = default;

osg::ref_ptr<GroundTile> GroundTile::ofAll(const Part& part, double finestSpacing) {
    const glm::dvec2 extent = part->high - part->low;
    double spacing = finestSpacing;
    int levels = 0;
    for (const double side = std::max(extent.x, extent.y); groundSquares * spacing < side; spacing *= 2.0)
        ++levels;
    const osg::ref_ptr<GroundTile> all = new GroundTile(part, part->low, spacing, levels, osg::BoundingBox());
    std::call_once(all->_once, [&] { all->make(); });
    return all->_box.valid() ? all : osg::ref_ptr<GroundTile>();
}

void GroundTile::make() {
    const GroundMesh mesh(*_part, _corner, _spacing);
    _mesh = mesh.geometry;
    _mesh->setDataVariance(
        DYNAMIC); // osgUtil::Optimizer would flatten transforms above it, into this one only
    if (!_box.valid())
        for (const osg::BoundingBox& quarter : mesh.quarters)
            _box.expandBy(quarter);
    const double half = 0.5 * _spacing;
    for (std::size_t quarter = 0; _levels > 0 && quarter < 4; ++quarter)
        if (mesh.quarters[quarter].valid())
            _quarters[quarter] =
                new GroundTile(_part, _corner + groundSquares * half * glm::dvec2(quarter & 1, quarter >> 1),
                               half, _levels - 1, mesh.quarters[quarter]);
    _isMade = true;
}

/// Seen from a camera; to all others only the finest is.
bool GroundTile::isFineEnough(osg::NodeVisitor& visitor) const {
    const auto* view = visitor.asCullStack();
    if (_levels == 0 || !view)
        return _levels == 0;
    const osg::Vec3& eye = view->getEyeLocal();
    const osg::Vec3 nearest(std::clamp(eye.x(), _box.xMin(), _box.xMax()),
                            std::clamp(eye.y(), _box.yMin(), _box.yMax()),
                            std::clamp(eye.z(), _box.zMin(), _box.zMax()));
    const float pixels = view->clampedPixelSize(nearest, static_cast<float>(_spacing));
    return nearest != eye && pixels <= mostPixels * view->getLODScale();
}

void GroundTile::traverse(osg::NodeVisitor& visitor) {
    const osg::NodeVisitor::VisitorType type = visitor.getVisitorType();
    if (type == osg::NodeVisitor::CULL_VISITOR || type == osg::NodeVisitor::INTERSECTION_VISITOR) {
        std::call_once(_once,
                       [this] { EntryGuard().run("a part of the ground is left out", [this] { make(); }); });
        if (!_isMade)
            return;
        if (isFineEnough(visitor))
            return _mesh->accept(visitor);
    } else if (type != osg::NodeVisitor::NODE_VISITOR || !_isMade) // nothing here asks for updates or events
        return;
    else
        _mesh->accept(visitor);
    for (const osg::ref_ptr<GroundTile>& quarter : _quarters)
        if (quarter)
            quarter->accept(visitor);
}

void GroundTile::resizeGLObjectBuffers(unsigned size) {
    osg::Node::resizeGLObjectBuffers(size);
    if (!_isMade)
        return;
    _mesh->resizeGLObjectBuffers(size);
    for (const osg::ref_ptr<GroundTile>& quarter : _quarters)
        if (quarter)
            quarter->resizeGLObjectBuffers(size);
}

void GroundTile::releaseGLObjects(osg::State* state) const {
    osg::Node::releaseGLObjects(state);
    if (!_isMade)
        return;
    _mesh->releaseGLObjects(state);
    for (const osg::ref_ptr<GroundTile>& quarter : _quarters)
        if (quarter)
            quarter->releaseGLObjects(state);
}

} // namespace osgTreeWind
