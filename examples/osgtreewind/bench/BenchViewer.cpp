// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchViewer.h>

#include <examples/osgtreewind/bench/BenchClock.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/GLExtensions>
#include <osg/LightSource>
#include <osg/Stats>

#include <ctime>

namespace math = osgTreeWind::math;

namespace {

constexpr int lateFrames = 6; // frames until a timer query has answered

double aspectOf(const PictureSize& size) {
    return static_cast<double>(size.width) / size.height;
}

/// Waits until the driver has drawn the frame.
struct Finish : osg::Camera::DrawCallback {
    explicit Finish(BenchDriver& driver) : driver(driver) {}
    void operator()(osg::RenderInfo& renderInfo) const override {
        glFinish();
        if (driver.renderer.empty()) {
            driver.vendor = reinterpret_cast<const char*>(glGetString(GL_VENDOR));
            driver.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
            driver.version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
            driver.hasPipelineStatistics = osg::isGLExtensionOrVersionSupported(
                renderInfo.getContextID(), "GL_ARB_pipeline_statistics_query", 4.6f);
        }
    }
    BenchDriver& driver;
};

} // namespace

BenchViewer::BenchViewer(const PictureSize& size, osg::GraphicsContext& context, BenchDriver& driver,
                         std::vector<BenchVariant> variants, int frames)
    : _aspect(aspectOf(size)), _variants(std::move(variants)), _times(_variants.size()),
      _frames(_variants.size()) {
    osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
    sun->getLight()->setPosition({0.45f, -0.5f, 0.74f, 0.0f});
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(sun);
    for (const BenchVariant& variant : _variants)
        root->addChild(variant.node);

    osg::Camera& camera = *_viewer.getCamera();
    camera.setGraphicsContext(&context);
    camera.setViewport(0, 0, size.width, size.height);
    camera.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera.attach(osg::Camera::COLOR_BUFFER, GL_RGBA8);
    camera.setFinalDrawCallback(new Finish(driver));
    camera.setClearColor({0.78f, 0.86f, 0.93f, 1.0f});
    _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    _viewer.setKeyEventSetsDone(0);
    _viewer.setLightingMode(osg::View::NO_LIGHT);
    _viewer.setSceneData(root);

    const auto kept = static_cast<unsigned>(frames + lateFrames);
    _viewer.getViewerStats()->allocate(kept);
    _viewer.getViewerStats()->collectStats("update", true);
    camera.getStats()->allocate(kept);
    camera.getStats()->collectStats("rendering", true);
    // OSG's timer queries raise GL errors with OSMesa, where there is no GPU to time anyway.
    camera.getStats()->collectStats("gpu", osgTreeWind::offscreenBackendName() == std::string("egl"));
    _viewer.realize();
    const bool isCore = context.getTraits()->glContextProfileMask & 1;
    if (isCore &&
        osgTreeWind::osgProfile != osgTreeWind::ContextProfile::Core) // OSG applies what the profile lacks
        context.getState()->setCheckForGLErrors(osg::State::NEVER_CHECK_GL_ERRORS);
}

void BenchViewer::draw(std::size_t variant, double time) {
    for (std::size_t i = 0; i < _variants.size(); ++i)
        _variants[i].node->setNodeMask(i == variant ? ~0u : 0u);
    _viewer.getCamera()->setProjectionMatrixAsPerspective(_variants[variant].fieldOfView, _aspect, 1.0,
                                                          10000.0);
    _viewer.getCamera()->setViewMatrix(_variants[variant].view);
    _viewer.frame(time);
}

void BenchViewer::measure(std::size_t variant, double time) {
    const BenchClock clock;
    const std::clock_t before = std::clock();
    draw(variant, time);
    _times[variant].processor.push_back(1000.0 * static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC);
    _times[variant].frame.push_back(1000.0 * clock.seconds());
    _frames[variant].push_back(_viewer.getFrameStamp()->getFrameNumber());
}

std::vector<BenchTimes> BenchViewer::times(std::size_t variant, double time) {
    for (int i = 0; i < lateFrames; ++i)
        draw(variant, time);
    std::vector<BenchTimes> times = _times;
    for (std::size_t i = 0; i < times.size(); ++i)
        readStats(_frames[i], times[i]);
    return times;
}

void BenchViewer::readStats(const std::vector<unsigned>& frames, BenchTimes& times) {
    const auto read = [&frames](const osg::Stats& stats, const char* name, std::vector<double>& out) {
        for (const unsigned frame : frames)
            if (double seconds = 0.0; stats.getAttribute(frame, name, seconds))
                out.push_back(1000.0 * seconds);
    };
    const osg::Stats& rendering = *_viewer.getCamera()->getStats();
    read(*_viewer.getViewerStats(), "Update traversal time taken", times.update);
    read(rendering, "Cull traversal time taken", times.cull);
    read(rendering, "Draw traversal time taken", times.draw);
    read(rendering, "GPU draw time taken", times.gpu);
}

osg::Matrixd benchView(const PictureSize& size, const osg::BoundingSphere& bound) {
    const double halfAngle = osg::DegreesToRadians(0.5 * benchFieldOfView) * std::min(1.0, aspectOf(size));
    osg::Vec3d direction(-0.5, -1.0, 0.2);
    direction.normalize();
    return osg::Matrixd::lookAt(bound.center() + direction * (0.62 * bound.radius() / math::sin(halfAngle)),
                                bound.center(), osg::Z_AXIS);
}
