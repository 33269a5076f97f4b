// SPDX-License-Identifier: MIT
#pragma once

#include <osg/FrameBufferObject>
#include <osg/Program>
#include <osg/State>
#include <osg/Texture2D>

namespace osgTreeWind {

/// A pass within a draw: one rectangle of fragments into a frame buffer object, with nothing of the scene's
/// state in the way. What it changes in OpenGL is as before once it is gone, so that osg::State stays right.
class PassState {
public:
    explicit PassState(osg::State& state);
    ~PassState();
    PassState(const PassState&) = delete;
    PassState& operator=(const PassState&) = delete;

    /// Draws go into `height` rows of the target from `firstRow` on, by this program.
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
