// SPDX-License-Identifier: MIT
#include "OffscreenViewer.h"

#include <osgTreeWind/offscreen/FrameImage.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <iostream>

namespace {

/// Means of factor x factor pixels. Edges of leaves are as smooth as all others without OpenGL's own samples.
void averagePixels(const osg::Image& from, osg::Image& to, int factor) {
    const int count = factor * factor;
    for (int y = 0; y < to.t(); ++y) {
        for (int x = 0; x < to.s(); ++x) {
            int sum[4] = {};
            for (int i = 0; i < count; ++i) {
                const unsigned char* pixel = from.data(x * factor + i % factor, y * factor + i / factor);
                for (int channel = 0; channel < 4; ++channel)
                    sum[channel] += pixel[channel];
            }
            for (int channel = 0; channel < 4; ++channel)
                to.data(x, y)[channel] = static_cast<unsigned char>((sum[channel] + count / 2) / count);
        }
    }
}

} // namespace

OffscreenViewer::OffscreenViewer(int width, int height, int samplesAcross)
    : _samplesAcross(samplesAcross), _image(new osg::Image) {
    _image->allocateImage(width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    auto context = osgTreeWind::createOffscreenContext(width * samplesAcross, height * samplesAcross);
    if (!context) {
        std::cerr << context.problems().front().text() << '\n';
        return;
    }
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setKeyEventSetsDone(0);
    _viewer.setLightingMode(osg::View::NO_LIGHT);
    _drawn = osgTreeWind::attachFrameImage(*_viewer.getCamera(), *context.value());
    _viewer.getCamera()->setClearColor(osg::Vec4(0.78f, 0.86f, 0.93f, 1.0f));
    // Pixels are those of the picture, not samples.
    _viewer.getCamera()->setLODScale(static_cast<float>(samplesAcross));
}

osg::Image& OffscreenViewer::frame(double time) {
    _viewer.frame(time);
    averagePixels(*_drawn, *_image, _samplesAcross);
    return *_image;
}
