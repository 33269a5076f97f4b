// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Camera>
#include <osg/Image>

namespace osgTreeWind {

/// Makes a camera draw into an image, which each viewer.frame() overwrites.
///
/// Sets the camera's graphics context, its viewport to the whole context, and its render target to a frame
/// buffer object with an RGBA8 colour buffer and OSG's depth buffer of 24 bits. Does not change the view, the
/// projection with its aspect ratio, or the clear colour.
/// @param samples per pixel for anti-aliasing, limited to the maximum of the driver; 0 or 1: none.
/// @return the image: RGBA, bytes, bottom row first, which osgDB writes upright. The draw writes it: read it
/// after frame() of a viewer with the threading model SingleThreaded, and copy it before the next frame.
osg::ref_ptr<osg::Image> attachFrameImage(osg::Camera& camera, osg::GraphicsContext& context,
                                          int samples = 0);
/// The same with a viewport and an image of the given size. It may differ from that of the context, whose own
/// buffers stay unused.
osg::ref_ptr<osg::Image> attachFrameImage(osg::Camera& camera, osg::GraphicsContext& context, int width,
                                          int height, int samples);

} // namespace osgTreeWind
