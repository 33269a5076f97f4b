// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>

#include <osg/Geometry>

namespace osgTreeWind {

/// Vertex attributes of one tree in an instanced draw (shaders/instance.glsl, shaders/impostor.vert).
struct TreeInstance {
    float place[4]; ///< Foot in the forest's frame; tangent of half the heading (impostors: the heading).
    float
        size[4]; ///< Horizontal and vertical scale of lengths, scale of radii, scale of leaf clusters
                 ///< (impostors: the two length scales; the fall as a horizontal rotation vector x, y, rad).
    float state[4]; ///< Row of the poses, fade, random number of the tree, share of leaves (impostors: lean
                    ///< x, lean y, fade, random number).
    float light[4]; ///< Share of the light that neighbours leave at the foot and at the top; 1 / height, 1/m;
                    ///< 0.
};

/// The visible trees of one model and tier. Filled during cull, then drawn, by one thread at a time.
struct InstanceList : osg::Referenced {
    InstanceList() {
        osg::ref_ptr<osg::VertexBufferObject> buffer = new osg::VertexBufferObject;
        buffer->setUsage(GL_STREAM_DRAW_ARB);
        values->setVertexBufferObject(buffer);
    }
    void add(const TreeInstance& tree) {
        const float* first = tree.place;
        values->insert(values->end(), first, first + sizeof tree / sizeof(float));
    }
    std::size_t size() const { return values->size() * sizeof(float) / sizeof(TreeInstance); }
    void clear() {
        values->clear();
        passes = nullptr;
        page = nullptr;
    }

    osg::ref_ptr<osg::FloatArray> values = new osg::FloatArray;
    osg::ref_ptr<const PosePass> passes; ///< Null for impostors.
    osg::ref_ptr<PosePage> page;
    osg::Vec3 flutter; ///< Phases of the leaf flutter.
};

/// Draws one part (bark, leaves or impostors) of the trees of a list with instancing. Added to a render bin
/// by cull; not part of the scene graph.
class InstancedDraw : public osg::Drawable {
public:
    InstancedDraw();

    /// @param geometry of one tree, with vertices in buffer objects and DrawElements or DrawArrays.
    /// @param flush whether to call glFlush() after the draw. A software driver would otherwise not start
    /// before the end of the frame.
    void set(osg::Geometry* geometry, InstanceList* trees, bool flush = false);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

protected:
    ~InstancedDraw() override = default;

private:
    void drawTrees(osg::RenderInfo& renderInfo) const;

    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<InstanceList> _trees;
    bool _flush = false;
};

} // namespace osgTreeWind
