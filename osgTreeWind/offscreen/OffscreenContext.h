// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <osg/GL>
#include <osg/GraphicsContext>

namespace osgTreeWind {

/// Maximum width and height of an offscreen context, pixels.
constexpr int maxOffscreenSize = 16384;

/// Profiles of an OpenGL context.
enum class ContextProfile { Compatibility, Core };
/// The profile that OSG is built for.
#ifdef OSG_GL_FIXED_FUNCTION_AVAILABLE
constexpr ContextProfile osgProfile = ContextProfile::Compatibility;
#else
constexpr ContextProfile osgProfile = ContextProfile::Core;
#endif

/// Creates an OpenGL context that needs no display: RGBA8 colour, 24 bit depth, 8 bit stencil, single
/// buffered (on Windows a back buffer, which is never swapped), with its own osg::State and context id.
///
/// Assign it to a camera with setGraphicsContext(), and set the viewport, or use attachFrameImage().
/// osgViewer::Viewer and CompositeViewer accept it like any other context, in every threading model. The last
/// reference closes it and deletes its OpenGL objects. Contexts of Mesa's software renderer draw one after
/// another, even in different threads.
///
/// The program selects the backend when it is linked, with exactly one of osgTreeWind::OSMesa (Mesa's
/// software renderer), osgTreeWind::EGL (a GPU if there is one, else Mesa's software renderer) and, on
/// Windows, osgTreeWind::WGL (the driver's OpenGL). It may also open windows.
/// @param width, height in pixels, 1 to maxOffscreenSize.
/// @param profile of the context. In a core profile, only drawables whose state has a program are drawn. An
/// OSG that is not built for it gets generic vertex attributes and vertex array objects there.
/// @return a context that is valid() and not yet realized, or one problem. Any thread; leaves no context
/// current.
Result<osg::ref_ptr<osg::GraphicsContext>> createOffscreenContext(int width, int height,
                                                                  ContextProfile profile = osgProfile);

/// The backend of this program: "osmesa", "egl" or "wgl".
const char* offscreenBackendName();

} // namespace osgTreeWind
