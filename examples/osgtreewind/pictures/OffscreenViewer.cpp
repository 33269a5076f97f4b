// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/pictures/OffscreenViewer.h>

#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/pictures/SrgbTables.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/offscreen/FrameImage.h>

#include <glm/common.hpp>

#include <vector>

namespace {

/// Averages the linear light of factor x factor pixels. Unlike OpenGL's multisampling this also smooths the
/// edges of leaf textures. Both images have four bytes per pixel.
void averagePixels(const osg::Image& from, osg::Image& to, int factor) {
    const SrgbTables& tables = srgbTables();
    const int width = to.s();
    const float share = 1.0f / static_cast<float>(factor * factor);
    osgTreeWind::ThreadPool::executor()(static_cast<std::size_t>(to.t()), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        unsigned char* target = to.data(0, y); // osg::Image::data() is slow per pixel
        std::vector<float> sums(static_cast<std::size_t>(3 * width), 0.0f);
        for (int i = 0; i < factor; ++i) {
            const unsigned char* pixel = from.data(0, y * factor + i);
            for (int x = 0; x < width; ++x)
                for (int j = 0; j < factor; ++j, pixel += 4)
                    for (int channel = 0; channel < 3; ++channel)
                        sums[static_cast<std::size_t>(3 * x + channel)] += tables.linear[pixel[channel]];
        }
        for (int x = 0; x < width; ++x, target += 4) {
            for (int channel = 0; channel < 3; ++channel)
                target[channel] = tables.byte(sums[static_cast<std::size_t>(3 * x + channel)] * share);
            target[3] = 255;
        }
    });
}

} // namespace

OffscreenViewer::OffscreenViewer(int width, int height, int samplesAcross,
                                 osgTreeWind::ContextProfile profile)
    : _samplesAcross(samplesAcross), _image(new osg::Image) {
    _image->allocateImage(width, height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    const auto context = valueOrThrow(osgTreeWind::createOffscreenContext(1, 1, profile), Failed);
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setKeyEventSetsDone(0);
    _viewer.setLightingMode(osg::View::NO_LIGHT);
    _drawn = osgTreeWind::attachFrameImage(*_viewer.getCamera(), *context, width * samplesAcross,
                                           height * samplesAcross, 0);
    _viewer.getCamera()->setClearColor(osg::Vec4(0.78f, 0.86f, 0.93f, 1.0f));
    _viewer.getCamera()->setNearFarRatio(1e-5); // near plane 6 cm away with the edge of the ground at 6 km
    // Levels of detail count picture pixels, not samples.
    _viewer.getCamera()->setLODScale(static_cast<float>(samplesAcross));
}

osg::Image& OffscreenViewer::frame(double time) {
    _viewer.frame(time);
    averagePixels(*_drawn, *_image, _samplesAcross);
    return *_image;
}
