// SPDX-License-Identifier: MIT
#pragma once

#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osg/Program>
#include <osg/State>
#include <osg/Texture2D>

#include <vector>

namespace osgTreeWind {

/// GPU passes within a draw: they render rectangles into frame buffer objects, unaffected by the scene's
/// state. The destructor restores the OpenGL state that they changed, so that osg::State remains valid.
class PassState {
public:
    explicit PassState(osg::State& state);
    ~PassState();
    PassState(const PassState&) = delete;
    PassState& operator=(const PassState&) = delete;

    /// Directs draw() to `height` rows of the target from `firstRow` on, with this program.
    void begin(osg::Program& program, osg::FrameBufferObject& target, int firstRow, int width,
               int height) const;
    void bind(unsigned unit, const char* sampler, osg::Texture2D* texture) const; ///< @param unit below 5.
    void set(const char* uniform, int value) const;
    void draw() const;

private:
    static constexpr unsigned units = 5, targets = 3; ///< Those that the passes use.

    void disable(GLenum mode);

    osg::State& _state;
    const osg::GLExtensions& _gl;
    const osg::Program::PerContextProgram* _program;
    GLint _readFrameBuffer = 0, _drawFrameBuffer = 0, _programHandle = 0, _vertexArray = 0,
          _activeTexture = 0;
    GLint _viewport[4] = {}, _polygonMode[2] = {}, _textures[units] = {};
    GLboolean _blends[targets] = {}, _colorMasks[targets][4] = {};
    std::vector<GLenum> _disabled;
    GLuint _noArrays = 0;
};

} // namespace osgTreeWind
