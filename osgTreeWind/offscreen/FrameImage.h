// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osg/Image>

namespace osgTreeWind {

/// Makes a camera draw into an image: every viewer.frame() refills it.
///
/// Sets the camera's graphics context, its viewport to the whole context, and its render target to a frame
/// buffer object with an RGBA8 colour buffer and the depth buffer OSG adds (24 bit). View, projection (aspect
/// ratio too) and clear colour stay as they are.
/// @param samples per pixel for anti-aliasing; 0 or 1 for none. More than the driver offers become its
/// maximum.
/// @return the image: RGBA, bytes, the bottom row first as OSG has it, so that osgDB writes it upright. It is
/// written while the camera draws: read it after frame() of a viewer whose threading model is SingleThreaded,
/// and copy what must outlive the next frame.
osg::ref_ptr<osg::Image> attachFrameImage(osg::Camera& camera, osg::GraphicsContext& context,
                                          int samples = 0);

} // namespace osgTreeWind
