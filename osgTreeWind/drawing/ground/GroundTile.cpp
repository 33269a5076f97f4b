// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/ground/GroundTile.h>

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/gpu/ExceptionGuard.h>

#include <osg/CullStack>
#include <osg/NodeVisitor>

#include <glm/common.hpp>

#include <algorithm>

namespace osgTreeWind {
namespace {

constexpr float maxSpacing = 14.0f; // of vertices, pixels

} // namespace

GroundTile::GroundTile(DrawnGroundPtr part, const glm::dvec2& corner, double spacing, int levels,
                       const osg::BoundingBox& box)
    : _drawn(std::move(part)), _corner(corner), _spacing(spacing), _levels(levels), _box(box) {}

GroundTile::GroundTile(const GroundTile& other, const osg::CopyOp& copyop)
    : osg::Node(other, copyop), _drawn(other._drawn), _corner(other._corner), _spacing(other._spacing),
      _levels(other._levels), _box(other._box) {}

GroundTile::~GroundTile() = default;

void GroundTile::makeMesh() {
    const GroundMesh mesh(*_drawn, _corner, _spacing);
    _mesh = mesh.geometry;
    _mesh->setDataVariance(
        DYNAMIC); // osgUtil::Optimizer would flatten transforms above it, into this mesh only
    if (!_box.valid())
        for (const osg::BoundingBox& quarter : mesh.quarters)
            _box.expandBy(quarter);
    const double half = 0.5 * _spacing;
    for (std::size_t quarter = 0; _levels > 0 && quarter < 4; ++quarter)
        if (mesh.quarters[quarter].valid())
            _quarters[quarter] =
                new GroundTile(_drawn, _corner + groundSquares * half * glm::dvec2(quarter & 1, quarter >> 1),
                               half, _levels - 1, mesh.quarters[quarter]);
    _isMade = true;
}

/// Whether the mesh is fine enough for a camera. Other visitors get the finest level.
bool GroundTile::isFineEnough(osg::NodeVisitor& visitor) const {
    const auto* view = visitor.asCullStack();
    if (_levels == 0 || !view)
        return _levels == 0;
    const osg::Vec3& eye = view->getEyeLocal();
    const osg::Vec3 nearest(std::clamp(eye.x(), _box.xMin(), _box.xMax()),
                            std::clamp(eye.y(), _box.yMin(), _box.yMax()),
                            std::clamp(eye.z(), _box.zMin(), _box.zMax()));
    const float pixels = view->clampedPixelSize(nearest, static_cast<float>(_spacing));
    return nearest != eye && pixels <= maxSpacing * view->getLODScale();
}

void GroundTile::traverse(osg::NodeVisitor& visitor) {
    const osg::NodeVisitor::VisitorType type = visitor.getVisitorType();
    if (type == osg::NodeVisitor::CULL_VISITOR || type == osg::NodeVisitor::INTERSECTION_VISITOR) {
        std::call_once(_once, [this] {
            ExceptionGuard().run("a part of the ground is left out", [this] { makeMesh(); });
        });
        if (!_isMade)
            return;
        if (isFineEnough(visitor))
            return _mesh->accept(visitor);
    } else if (type != osg::NodeVisitor::NODE_VISITOR || !_isMade) // nothing here needs updates or events
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

osg::ref_ptr<osg::Node> createGroundDrawing(const GroundPtr& ground, const glm::dvec3& origin,
                                            const osg::BoundingSphere& trees) {
    constexpr double beyond = 50000.0, finest = 4.0; // metres
    constexpr Range cells = within(0.001, 1e8);
    if (!ground)
        return {};
    const GroundArea area = ground->area();
    const glm::dvec2 centre = glm::dvec2(origin) + glm::dvec2(trees.center().x(), trees.center().y());
    const double reach = std::max(static_cast<double>(trees.radius()), 0.0) + beyond;
    const DrawnGround drawn{ground, origin, glm::max(area.low, centre - reach),
                            glm::min(area.high, centre + reach)};
    const glm::dvec2 extent = drawn.high - drawn.low;
    if (!(extent.x > 0.0 && extent.y > 0.0 && cells.contains(area.cell)))
        return {};
    double spacing = 0.5 * area.cell; // a bilinear surface is not flat inside a cell
    while (spacing > finest)
        spacing *= 0.5;
    int levels = 0;
    for (const double side = std::max(extent.x, extent.y); groundSquares * spacing < side; spacing *= 2.0)
        ++levels;
    const osg::ref_ptr<GroundTile> all =
        new GroundTile(std::make_shared<const DrawnGround>(drawn), drawn.low, spacing, levels, {});
    std::call_once(all->_once, [&] { all->makeMesh(); });
    return all->_box.valid() ? all : osg::ref_ptr<GroundTile>();
}

} // namespace osgTreeWind
