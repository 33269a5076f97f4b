// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/gpu/PosePass.h>

#include <osg/Geometry>

#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Vertex attributes of one tree in an instanced draw (shaders/instance.glsl, shaders/impostor.vert).
struct TreeInstance {
    float place[4]; ///< Foot in the forest's frame; tangent of half the heading (impostors: the heading).
    float
        size[4]; ///< Horizontal and vertical scale of lengths, scale of radii, scale of leaf clusters
                 ///< (impostors: the two length scales; the fall as a horizontal rotation vector x, y, rad).
    float state[4]; ///< First block of the poses, fade, random number of the tree, share of leaves
                    ///< (impostors: lean x, lean y, fade, random number).
    float light[4]; ///< Share of the light that neighbours leave at the foot and at the top; 1 / height, 1/m;
                    ///< tier plus an eighth of its leaf brightness (impostors: 0, 0).
};

/// A draw of a range of indices, as OpenGL's indirect draws store it.
struct DrawCommand {
    std::uint32_t indices, instances, firstIndex;
    std::int32_t firstVertex;
    std::uint32_t firstInstance;
};

class SceneGeometry;

/// What one camera draws of a forest in a frame, in one buffer object: instances and commands. Filled during
/// cull, then drawn, by one thread at a time.
struct DrawBuffer : osg::Referenced {
    DrawBuffer();
    void clear();
    /// @return its index.
    std::uint32_t add(const TreeInstance& tree);
    std::uint32_t add(const DrawCommand* commands, std::size_t count);
    std::size_t instanceCount() const { return instances->size() * sizeof(float) / sizeof(TreeInstance); }
    void releaseGLObjects(osg::State* state);

    osg::ref_ptr<osg::FloatArray> instances = new osg::FloatArray;
    osg::ref_ptr<osg::UIntArray> commands = new osg::UIntArray;
    std::uint64_t id; ///< Of the buffer object, whose name OpenGL may give to a later one.
    osg::ref_ptr<const PosePass> poses;
    bool hasHostState = false; ///< Whether draws have state of a host, which may change the lights.

    /// Sets what follows for the draws of a camera, in its context.
    void beginDraws(osg::State& state);
    std::uint64_t scope = 0; ///< For applySceneUniforms().
    bool isCore = false;     ///< isCoreProfile()
    bool isIndirect = false; ///< hasIndirectDraws()
};

/// Whether a context has indirect draws with base instances.
bool hasIndirectDraws(const osg::State& state);

/// The poses that trees of a draw share.
struct DrawnPoses {
    osg::ref_ptr<PosePage> page; ///< Null for impostors.
    osg::Vec3 flutter;           ///< Phases of the leaf flutter.
};

/// Draws one part (bark, leaves or impostors) of trees of one model. Added to a render bin by cull; not part
/// of the scene graph.
class InstancedDraw : public osg::Drawable {
public:
    InstancedDraw();

    /// @param geometry of one tree, with vertices in buffer objects.
    /// @param flush whether to call glFlush() after the draw. A software driver would otherwise not start
    /// before the end of the frame.
    void set(osg::Geometry* geometry, DrawBuffer* buffer, const DrawnPoses& poses, bool flush);
    /// Draws instances, each with all primitives of the geometry: DrawElements or DrawArrays.
    void drawInstances(std::uint32_t first, std::uint32_t count);
    /// Draws commands, whose indices are those of the first primitives of a SceneGeometry, DrawElements.
    void drawCommands(std::uint32_t first, std::uint32_t count);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

protected:
    ~InstancedDraw() override = default;

private:
    void drawTrees(osg::RenderInfo& renderInfo, const SceneGeometry* withObject) const;
    void bindArrays(osg::RenderInfo& renderInfo, const SceneGeometry* withObject) const;
    void unbindArrays(osg::State& state) const;
    void setInstances(const osg::State& state, std::uint32_t first) const;
    void drawParts(osg::State& state) const;
    void drawWhole(osg::State& state) const;

    osg::ref_ptr<osg::Geometry> _geometry;
    osg::ref_ptr<DrawBuffer> _buffer;
    DrawnPoses _poses;
    bool _hasCommands = false, _flush = false;
    std::uint32_t _first = 0, _count = 0; ///< Instances or commands.
};

} // namespace osgTreeWind
