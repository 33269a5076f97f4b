// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/GraphicsContext>

#include <mutex>
#include <optional>

namespace osgTreeWind {

inline const char* profileName(ContextProfile profile) {
    return profile == ContextProfile::Core ? "core" : "compatibility";
}

/// Base class of the offscreen backends, with traits, state and context id. A backend implements valid(),
/// makeCurrentImplementation(), releaseContextImplementation() and closeImplementation(), and calls close()
/// in its destructor.
class OffscreenContextBase : public osg::GraphicsContext {
public:
    /// The problem with a size in pixels; empty if it is valid.
    static std::optional<Diagnostic> sizeProblem(int width, int height);

    bool realizeImplementation() override;
    bool isRealizedImplementation() const override { return _realized; }
    /// @return false unless `readContext` is this context: each context has one surface only.
    bool makeContextCurrentImplementation(osg::GraphicsContext* readContext) override;
    /// Not supported: gives an OSG_WARN.
    void bindPBufferToTextureImplementation(GLenum buffer) override;
    void swapBuffersImplementation() override {}
    /// Draws. Contexts of Mesa's software renderer draw one after another.
    void runOperations() override;

    const char* libraryName() const override { return "osgTreeWind"; }

protected:
    OffscreenContextBase(int width, int height, ContextProfile profile);

    /// Locks the mutex that all contexts of Mesa's software renderer share; an empty lock for other
    /// renderers. Hold it during calls of OpenGL. Mesa 22.3 has a data race: to find pending reads of a
    /// resource, a context examines all other contexts, even while their threads free them
    /// (lp_setup_is_resource_referenced).
    std::unique_lock<std::recursive_mutex> lockSoftwareRenderer() const;

    bool _realized = false;
    bool _isSoftwareRenderer = true; ///< Assumed until the renderer is known.
};

} // namespace osgTreeWind
