// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/ground/GroundMesh.h>

#include <osg/Node>

#include <atomic>
#include <mutex>

namespace osgTreeWind {

/// A square of the ground: as a mesh, or where its vertices would stand more than a few pixels apart as four
/// tiles of half its side. Meshes are made as they are first seen, by whoever culls, and the same whenever
/// that is. Its statesets are those of any node.
class GroundTile : public osg::Node {
public:
    using Part = std::shared_ptr<const DrawnGround>;
    /// @param corner the south-west one, in the world's frame. @param spacing of vertices, metres.
    /// @param levels of halves below it. @param box what holds it, in the forest's frame.
    GroundTile(Part part, const glm::dvec2& corner, double spacing, int levels, const osg::BoundingBox& box);

    const char* libraryName() const override { return "osgTreeWind"; }
    const char* className() const override { return "GroundTile"; }
    osg::Object* cloneType() const override {
        return new GroundTile(_part, _corner, _spacing, _levels, _box);
    }
    /// A copy makes meshes of its own.
    osg::Object* clone(const osg::CopyOp& copyop) const override { return new GroundTile(*this, copyop); }

    void traverse(osg::NodeVisitor& visitor) override;
    osg::BoundingSphere computeBound() const override { return osg::BoundingSphere(_box); }
    void resizeGLObjectBuffers(unsigned size) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~GroundTile() override;

private:
    friend osg::ref_ptr<osg::Node> createGroundDrawing(const GroundPtr&, const glm::dvec3&,
                                                       const osg::BoundingSphere&);
    GroundTile(const GroundTile& other, const osg::CopyOp& copyop);
    void make();
    bool isFineEnough(osg::NodeVisitor& visitor) const;

    Part _part;
    glm::dvec2 _corner;
    double _spacing;
    int _levels;
    osg::BoundingBox _box;
    std::once_flag _once;
    std::atomic<bool> _isMade{false}; ///< What follows is there, and does not change any more.
    osg::ref_ptr<osg::Geometry> _mesh;
    std::array<osg::ref_ptr<GroundTile>, 4> _quarters; ///< Null where there is nothing, or no level below.
};

/// A ground about a forest, up to 50 km beyond it, in the forest's frame: triangles with normals and texture
/// coordinates in metres, finer where a camera is near. Null if there is no ground within that.
/// @param origin of the forest. @param trees what holds them, in the forest's frame.
osg::ref_ptr<osg::Node> createGroundDrawing(const GroundPtr& ground, const glm::dvec3& origin,
                                            const osg::BoundingSphere& trees);

} // namespace osgTreeWind
