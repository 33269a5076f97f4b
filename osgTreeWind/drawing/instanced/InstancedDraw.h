// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>

#include <osg/Geometry>

namespace osgTreeWind {

/// A tree in an instanced draw: its vertex attributes (shaders/instance.glsl, shaders/impostor.vert).
struct TreeInstance {
    float place[4]; ///< Foot in the forest's frame; tangent of half its heading (impostors: the heading).
    float size[4];  ///< Scale of lengths across and upward, of radii, of leaf clusters (impostors: those of
                    ///< lengths; how far it has come down, a level rotation vector x, y, radians).
    float state[4]; ///< Row of its poses, fade, its own number, share of its leaves (impostors: lean x, lean
                    ///< y, fade, its own number).
    float light[4]; ///< What its neighbours leave of the light at its foot and at its top; one over its
                    ///< height, 1/m; 0.
};

/// Trees of one model and tier that a camera sees in one frame. Filled in cull, then drawn, by one thread at
/// a time.
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
    osg::ref_ptr<const PosePass> passes; ///< None for impostors.
    osg::ref_ptr<PosePage> page;
    osg::Vec3 flutter; ///< Phases of the leaves' waves.
};

/// One part (bark, leaves, impostors) of the trees of a list, in one instanced draw. Made by cull for a
/// frame; never part of the scene graph.
class InstancedDraw : public osg::Drawable {
public:
    InstancedDraw();

    /// @param geometry of one tree, its vertices in buffer objects; DrawElements and DrawArrays are drawn.
    /// @param isLast of a batch: the driver is told to begin, as one that draws on processors would else wait
    /// for the end of the frame.
    void set(osg::Geometry* geometry, InstanceList* trees, bool isLast = false);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

protected:
    ~InstancedDraw() override = default;

private:
    void drawTrees(osg::RenderInfo& renderInfo) const;

    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<InstanceList> _trees;
    bool _isLast = false;
};

} // namespace osgTreeWind
