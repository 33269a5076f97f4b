// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <osg/GraphicsContext>

#include <mutex>
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
    /// Draws; with Mesa's software renderer while no other context does.
    void runOperations() override;

    const char* libraryName() const override { return "osgTreeWind"; }

protected:
    PixelContext(int width, int height);

    /// What calls OpenGL holds this: all contexts of Mesa's software renderer have one lock, others none.
    /// Mesa looks for what one context is about to write in what all of them are about to read, also while
    /// their threads free it (22.3: lp_setup_is_resource_referenced).
    std::unique_lock<std::recursive_mutex> turn() const;

    bool _realized = false;
    bool _takesTurns = true; ///< Until the renderer is known.
};

} // namespace osgTreeWind
