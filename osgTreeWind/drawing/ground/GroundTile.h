// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/ground/GroundMesh.h>

#include <osg/Node>

#include <atomic>
#include <mutex>

namespace osgTreeWind {

/// A square tile of the ground, drawn as a mesh, or as four tiles of half its side if its vertices would be
/// more than a few pixels apart on the screen. The first cull or pick that reaches a tile builds its mesh.
class GroundTile : public osg::Node {
public:
    using DrawnGroundPtr = std::shared_ptr<const DrawnGround>;
    /// @param corner south-west corner, in the world's frame. @param spacing of the vertices, metres.
    /// @param levels number of finer levels. @param box bounds in the forest's frame; invalid if unknown.
    GroundTile(DrawnGroundPtr part, const glm::dvec2& corner, double spacing, int levels,
               const osg::BoundingBox& box);

    const char* libraryName() const override { return "osgTreeWind"; }
    const char* className() const override { return "GroundTile"; }
    osg::Object* cloneType() const override {
        return new GroundTile(_drawn, _corner, _spacing, _levels, _box);
    }
    /// The copy builds its own meshes.
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
    void makeMesh();
    bool isFineEnough(osg::NodeVisitor& visitor) const;

    DrawnGroundPtr _drawn;
    glm::dvec2 _corner;
    double _spacing;
    int _levels;
    osg::BoundingBox _box;
    std::once_flag _once;
    std::atomic<bool> _isMade{false}; ///< If true, the members below are final.
    osg::ref_ptr<osg::Geometry> _mesh;
    std::array<osg::ref_ptr<GroundTile>, 4> _quarters; ///< Null without ground, and at the finest level.
};

/// Draws the ground around a forest, up to 50 km beyond it, in the forest's frame: triangles with normals and
/// texture coordinates in metres, finer near the camera. Null if there is no ground within that distance.
/// @param origin of the forest. @param trees bounds of the trees, in the forest's frame.
osg::ref_ptr<osg::Node> createGroundDrawing(const GroundPtr& ground, const glm::dvec3& origin,
                                            const osg::BoundingSphere& trees);

} // namespace osgTreeWind
