// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Result.h>

#include <osg/GraphicsContext>

namespace osgTreeWind {

/// Largest width and height of an offscreen context, in pixels.
constexpr int maxOffscreenSize = 16384;

/// Makes an OpenGL context that needs no display: compatibility profile, RGBA8 colour, 24 bit depth, 8 bit
/// stencil, single buffered, with an osg::State and a context id of its own.
///
/// Give it to a camera with setGraphicsContext and a viewport; osgViewer::Viewer and CompositeViewer use it
/// like any other context, in every threading model. It closes, and deletes its OpenGL objects, with its last
/// reference. Those of Mesa's software renderer draw one after the other, whatever threads they are drawn by.
///
/// The backend is decided when a program is linked: osgTreeWind::OSMesa (Mesa's software renderer) or
/// osgTreeWind::EGL (a GPU where there is one, else Mesa's software renderer). Link exactly one of them.
/// @param width, height pixels, 1 to maxOffscreenSize.
/// @return a context that is valid() and not yet realized, or one problem that says what was missing.
/// May be called from any thread; no context is left current on it.
Result<osg::ref_ptr<osg::GraphicsContext>> createOffscreenContext(int width, int height);

/// "osmesa" or "egl": the backend this program was linked with.
const char* offscreenBackendName();

} // namespace osgTreeWind
