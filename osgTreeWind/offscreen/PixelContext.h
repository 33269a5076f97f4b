// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <osg/GraphicsContext>

#include <optional>

namespace osgTreeWind {

/// What the backends share: traits, state, context id and the calls that mean nothing without a window.
/// Internal; a backend adds makeCurrentImplementation, releaseContextImplementation, closeImplementation and
/// valid, and calls close() in its destructor.
class PixelContext : public osg::GraphicsContext {
public:
    /// The problem with a size, if it has one.
    static std::optional<Diagnostic> sizeProblem(int width, int height);

    bool realizeImplementation() override;
    bool isRealizedImplementation() const override { return _realized; }
    /// There is one surface to a context, so the other context is not read from: returns false unless it is
    /// this.
    bool makeContextCurrentImplementation(osg::GraphicsContext* readContext) override;
    /// Not supported; warns.
    void bindPBufferToTextureImplementation(GLenum buffer) override;
    void swapBuffersImplementation() override {}

    const char* libraryName() const override { return "osgTreeWind"; }

protected:
    PixelContext(int width, int height);

    bool _realized = false;
};

} // namespace osgTreeWind
