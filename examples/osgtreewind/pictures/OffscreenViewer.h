// SPDX-License-Identifier: MIT
#pragma once

#include <osgViewer/Viewer>

/// Draws pictures without a display.
class OffscreenViewer {
public:
    /// Ends the command where there is no context. @param samplesAcross a pixel, whose means smooth edges.
    OffscreenViewer(int width, int height, int samplesAcross);

    osgViewer::Viewer& viewer() { return _viewer; }
    /// RGBA; until the next one.
    osg::Image& frame(double time);

private:
    int _samplesAcross;
    osgViewer::Viewer _viewer;
    osg::ref_ptr<osg::Image> _drawn, _image;
};
