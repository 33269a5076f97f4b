// SPDX-License-Identifier: MIT
#include "BenchRun.h"

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osg/GL>
#include <osg/LightSource>
#include <osg/Stats>
#include <osgViewer/Viewer>

#include <chrono>

using namespace osgTreeWind;

namespace {

constexpr int stepsPerWind = 30; // then it turns, so that the trees sway about their rest

/// Waits until the driver has drawn the frame.
struct Finish : osg::Camera::DrawCallback {
    explicit Finish(BenchDriver& driver) : driver(driver) {}
    void operator()(osg::RenderInfo&) const override {
        glFinish();
        if (driver.renderer.empty()) {
            driver.vendor = reinterpret_cast<const char*>(glGetString(GL_VENDOR));
            driver.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
            driver.version = reinterpret_cast<const char*>(glGetString(GL_VERSION));
        }
    }
    BenchDriver& driver;
};

class CountVisitor : public osg::NodeVisitor {
public:
    using osg::NodeVisitor::apply;
    CountVisitor() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Node& node) override {
        ++counts.nodes;
        traverse(node);
    }
    void apply(osg::Camera& node) override { apply(static_cast<osg::Node&>(node)); } // those of the passes
    void apply(osg::Transform& node) override {
        ++counts.transforms;
        apply(static_cast<osg::Node&>(node));
    }
    void apply(osg::Drawable& node) override {
        ++counts.drawables;
        apply(static_cast<osg::Node&>(node));
    }
    BenchCounts counts;
};

BenchCounts count(const BenchStage& stage, Forest& forest) {
    CountVisitor visitor;
    forest.accept(visitor);
    BenchCounts counts = visitor.counts;
    const ForestSimulation& simulation = forest.getSimulation();
    for (const PlacedTree& tree : simulation.trees()) {
        const TreeModel& model = simulation.models()[tree.model];
        const TreeCounts of = countTree(model);
        counts.units += of.units;
        if (stage.geometry <= BenchStage::BUFFERED_LINES) {
            counts.vertices += of.skeletonPoints;
            counts.lines += of.units * static_cast<std::uint64_t>(model.skeleton.ringsPerBranch - 1);
        } else {
            counts.vertices += of.totalVertices();
            counts.triangles += of.totalTriangles();
        }
    }
    return counts;
}

void placeCamera(osg::Camera& camera, const PictureSize& size, const osg::BoundingSphere& bound) {
    constexpr double fieldOfView = 40.0; // degrees
    const double aspect = static_cast<double>(size.width) / size.height;
    const double halfAngle = osg::DegreesToRadians(0.5 * fieldOfView) * std::min(1.0, aspect);
    osg::Vec3d direction(-0.5, -1.0, 0.2);
    direction.normalize();
    camera.setViewMatrixAsLookAt(bound.center() + direction * (0.62 * bound.radius() / std::sin(halfAngle)),
                                 bound.center(), osg::Z_AXIS);
    camera.setProjectionMatrixAsPerspective(fieldOfView, aspect, 1.0, 10000.0);
    camera.setClearColor({0.78f, 0.86f, 0.93f, 1.0f});
}

/// A viewer over both scenes.
class Bench {
public:
    Bench(const BenchScene& scene, const BenchSettings& settings, osg::GraphicsContext& context,
          BenchDriver& driver)
        : _scene(scene), _settings(settings), _winds{createBenchWind(false), createBenchWind(true)} {
        osg::ref_ptr<osg::LightSource> sun = new osg::LightSource;
        sun->getLight()->setPosition({0.45f, -0.5f, 0.74f, 0.0f});
        osg::ref_ptr<osg::Group> root = new osg::Group;
        root->addChild(sun);
        root->addChild(scene.moving);
        root->addChild(scene.still);

        osg::Camera& camera = *_viewer.getCamera();
        camera.setGraphicsContext(&context);
        camera.setViewport(0, 0, settings.size.width, settings.size.height);
        camera.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
        camera.attach(osg::Camera::COLOR_BUFFER, GL_RGBA8);
        camera.setFinalDrawCallback(new Finish(driver));
        placeCamera(camera, settings.size, scene.still->getBound());
        _viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
        _viewer.setKeyEventSetsDone(0);
        _viewer.setLightingMode(osg::View::NO_LIGHT);
        _viewer.setSceneData(root);

        const auto frames = static_cast<unsigned>(2 * (settings.frames + settings.warmUp) + spare);
        _viewer.getViewerStats()->allocate(frames);
        _viewer.getViewerStats()->collectStats("update", true);
        camera.getStats()->allocate(frames);
        camera.getStats()->collectStats("rendering", true);
        // OSG's timer queries raise GL errors with OSMesa, where there is no GPU to time anyway.
        camera.getStats()->collectStats("gpu", offscreenBackendName() == std::string("egl"));
        _viewer.realize();
    }

    void run(BenchTimes& moving, BenchTimes& still) {
        std::vector<unsigned> movingFrames, stillFrames;
        for (int pair = 0; pair < _settings.warmUp + _settings.frames; ++pair) {
            _scene.moving->setWind(_winds[_step / stepsPerWind % 2]);
            const double movingTime = frame(true), stillTime = frame(false);
            if (pair < _settings.warmUp)
                continue;
            moving.frame.push_back(movingTime);
            movingFrames.push_back(_viewer.getFrameStamp()->getFrameNumber() - 1);
            still.frame.push_back(stillTime);
            stillFrames.push_back(_viewer.getFrameStamp()->getFrameNumber());
        }
        for (int i = 0; i < spare; ++i)
            frame(false); // timer queries answer some frames later
        readStats(movingFrames, moving);
        readStats(stillFrames, still);
    }

private:
    static constexpr int spare = 6;

    /// @return milliseconds.
    double frame(bool moving) {
        _scene.moving->setNodeMask(moving ? ~0u : 0u);
        _scene.still->setNodeMask(moving ? 0u : ~0u);
        _step += moving ? 1 : 0;
        const auto start = std::chrono::steady_clock::now();
        _viewer.frame(_step * _settings.step);
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    }

    void readStats(const std::vector<unsigned>& frames, BenchTimes& times) {
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

    const BenchScene& _scene;
    const BenchSettings& _settings;
    WindFieldPtr _winds[2];
    osgViewer::Viewer _viewer;
    int _step = 0;
};

} // namespace

Result<BenchResult> runBench(const BenchStage& stage, int trees, const BenchSettings& settings,
                             BenchDriver& driver) {
    auto context = createOffscreenContext(settings.size.width, settings.size.height);
    if (!context)
        return context.problems();
    BenchResult result;
    result.stage = stage;
    result.trees = trees;
    const BenchScene scene = createBenchScene(stage, trees);
    Bench(scene, settings, *context.value(), driver).run(result.moving, result.still);
    result.gpuAngles = scene.moving->getBranchwise()->getAngleSource() == BranchwiseForest::GPU_ANGLES;
    scene.moving->setNodeMask(~0u);
    result.counts = count(stage, *scene.moving);
    return result;
}
