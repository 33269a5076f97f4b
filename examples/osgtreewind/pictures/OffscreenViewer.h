// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgViewer/Viewer>

/// Draws pictures without a display.
class OffscreenViewer {
public:
    /// Throws CommandError if there is no OpenGL context.
    /// @param samplesAcross samples per pixel in each direction.
    OffscreenViewer(int width, int height, int samplesAcross,
                    osgTreeWind::ContextProfile profile = osgTreeWind::osgProfile);

    osgViewer::Viewer& viewer() { return _viewer; }
    /// Draws a frame. @return RGBA image, valid until the next call.
    osg::Image& frame(double time);

private:
    int _samplesAcross;
    osgViewer::Viewer _viewer;
    osg::ref_ptr<osg::Image> _drawn, _image;
};
