// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchCalls.h>

#include <examples/osgtreewind/bench/BenchWood.h>
#include <examples/osgtreewind/scene/Daylight.h>
#include <examples/osgtreewind/scene/DefaultView.h>

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>

using namespace osgTreeWind;

namespace {

constexpr std::size_t treesOfWood = 10000;

osg::Matrixd lookAt(const osg::Vec3d& eye, const osg::Vec3d& center) {
    return osg::Matrixd::lookAt(eye, center, osg::Vec3d(0.0, 0.0, 1.0));
}

/// Counts scenes one after another.
class CallCounter {
public:
    CallCounter(const BenchSettings& settings, BenchDriver& driver) : _settings(settings), _driver(driver) {}

    BenchCalls count(const std::string& scene, Forest& forest, const osg::Matrixd& view,
                     double fieldOfView = benchFieldOfView) {
        const PictureSize& size = _settings.size;
        const auto context =
            valueOrThrow(createOffscreenContext(size.width, size.height, _settings.profile), Failed);
        BenchViewer viewer(size, *context, _driver, {{&forest, view, fieldOfView}}, 0);
        const auto draw = [&](int frames) {
            for (int i = 0; i < frames; ++i)
                viewer.draw(0, _time += _settings.step);
        };
        draw(_settings.warmUp);
        BenchCalls result;
        result.scene = scene;
        result.frames = _settings.frames;
        result.counts = countGlCalls([&] { draw(_settings.frames); });
        result.hasWork = _driver.hasPipelineStatistics;
        result.work = countGlCalls([&] { draw(1); }, result.hasWork).work;
        if (forest.getInstanced())
            for (const std::size_t trees : instancedTrees(*forest.getInstanced()).treesByTier())
                result.trees += trees;
        return result;
    }

private:
    const BenchSettings& _settings;
    BenchDriver& _driver;
    double _time = 0.0;
};

} // namespace

DrawWork BenchCalls::allWork() const {
    DrawWork all;
    for (const DrawWork& part : work)
        all.add(part);
    return all;
}

std::vector<BenchCalls> runBenchCalls(const BenchSettings& settings, BenchDriver& driver) {
    const osg::ref_ptr<Forest> wood = new Forest(createWood(treesOfWood));
    const osg::BoundingSphere bound = wood->getBound();
    const osg::Matrixd inside = viewOf(bound, BenchViewpoint::Inside, settings.size),
                       over = viewOf(bound, BenchViewpoint::Over, settings.size);
    const osg::Vec3d eye(bound.center().x(), bound.center().y(), 1.7);
    const osg::Matrixd down = lookAt(eye, eye + osg::Vec3d(0.0, 20.0, -9.7));
    const BenchScene tree = createBenchScene(stageOfInstances(), 1);
    CallCounter counter(settings, driver);
    return {counter.count("in the wood", *wood, inside), counter.count("in it, the ground", *wood, down),
            counter.count("in it, telescope", *wood, inside, 15.0),
            counter.count("above the wood", *wood, over),
            counter.count("one tree", *tree.forest, benchView(settings.size, tree.still->getBound()))};
}

BenchCalls runBenchCalls(const std::string& name, const ForestDescription& description,
                         const BenchSettings& settings, BenchDriver& driver) {
    const osg::ref_ptr<Forest> forest = new Forest(description);
    const Lens lens{benchFieldOfView, static_cast<double>(settings.size.width) / settings.size.height};
    const ForestView view = viewAtEyeLevel(*forest, lens, Daylight::usualSun);
    return CallCounter(settings, driver).count(name, *forest, lookAt(view.eye, view.center));
}
