// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Geometry>
#include <osg/Program>
#include <osg/VertexArrayState>
#include <osg/buffered_value>

#include <cstdint>

namespace osgTreeWind {

/// A geometry that is also drawn in a core profile: its program gets the uniforms of the scene there
/// (SceneUniforms.h), and without a program of the host, it is drawn with its own.
class SceneGeometry : public osg::Geometry {
public:
    /// @param program for a core profile without a program of the host; may be null.
    explicit SceneGeometry(osg::Program* program = nullptr);

    void drawImplementation(osg::RenderInfo& renderInfo) const override;

    /// Whether bindVertices() works in a context: contexts do not share vertex array objects, but those that
    /// share other objects have one number, so only the first of them has any.
    bool canBindVertices(const osg::State& state) const;
    /// Binds a vertex array object with the vertices, for draws with further attributes. In a draw; end with
    /// unbindVertices().
    /// @param attributes a number that identifies the further attributes; 0 if they differ in each draw.
    /// @return whether it lacks them.
    bool bindVertices(osg::RenderInfo& renderInfo, std::uint64_t attributes) const;
    static void unbindVertices(osg::State& state);

    void resizeGLObjectBuffers(unsigned maxSize) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

protected:
    ~SceneGeometry() override = default;

private:
    osg::ref_ptr<osg::Program> _program;
    struct BoundVertices {
        osg::ref_ptr<osg::VertexArrayState> arrays;
        std::uint64_t attributes = 0;
    };
    mutable osg::buffered_object<BoundVertices> _vertices;
};

} // namespace osgTreeWind
