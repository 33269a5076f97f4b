// SPDX-License-Identifier: MIT
#pragma once

#include <osg/FrameBufferObject>
#include <osg/Program>
#include <osg/State>
#include <osg/Texture2D>

namespace osgTreeWind {

/// A GPU pass within a draw: renders one rectangle into a frame buffer object, unaffected by the scene's
/// state. Its destructor restores the OpenGL state, so that osg::State remains valid.
class PassState {
public:
    explicit PassState(osg::State& state);
    ~PassState();
    PassState(const PassState&) = delete;
    PassState& operator=(const PassState&) = delete;

    /// Directs draw() to `height` rows of the target from `firstRow` on, with this program.
    void begin(osg::Program& program, osg::FrameBufferObject& target, int firstRow, int width,
               int height) const;
    void bind(unsigned unit, const char* sampler, osg::Texture2D* texture) const;
    void set(const char* uniform, int value) const;
    void draw() const;

private:
    osg::State& _state;
    const osg::GLExtensions& _gl;
    mutable const osg::Program::PerContextProgram* _program = nullptr;
    GLint _formerFrameBuffer = 0, _formerDrawFrameBuffer = 0, _formerProgram = 0;
};

} // namespace osgTreeWind
