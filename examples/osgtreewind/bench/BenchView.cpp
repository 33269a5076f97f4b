// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchView.h>

#include <examples/osgtreewind/bench/BenchClock.h>
#include <examples/osgtreewind/bench/BenchWood.h>
#include <examples/osgtreewind/scene/DefaultView.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/system/Memory.h>

using namespace osgTreeWind;

namespace {

constexpr int warmUpRounds = 4;
constexpr std::size_t fewTrees = 100; // memory of such a forest is mostly that of its shapes

/// Makes a forest and records time and memory.
osg::ref_ptr<Forest> makeForest(const std::function<ForestDescription()>& make, BenchView& result) {
    const double before = allocatedBytes();
    osg::ref_ptr<Forest> forest;
    {
        ForestDescription description = make();
        const BenchClock clock;
        forest = new Forest(std::move(description));
        result.forestSeconds = clock.seconds();
    }
    if (before > 0.0)
        result.forestBytes = allocatedBytes() - before;
    const ForestSimulation& simulation = forest->getSimulation();
    result.trees = forest->getNumTrees();
    result.shapes = movingForest(simulation).models().size();
    if (const ModalMotion* modal = movingForest(simulation).modal()) {
        result.archetypes = modal->archetypeCount();
        result.archetypeBytes = modal->archetypeBytes();
    }
    return forest;
}

} // namespace

const BenchStage& stageOfInstances() {
    const std::vector<BenchStage>& stages = benchStages();
    return *std::find_if(stages.begin(), stages.end(),
                         [](const BenchStage& stage) { return stage.method == BenchStage::INSTANCES; });
}

osg::Matrixd viewOf(const osg::BoundingSphere& bound, BenchViewpoint viewpoint, const PictureSize& size) {
    const osg::Vec3d centre = bound.center(), up(0.0, 0.0, 1.0);
    const double aspect = static_cast<double>(size.width) / size.height;
    switch (viewpoint) {
    case BenchViewpoint::Over:
        return osg::Matrixd::lookAt(defaultEye(centre, bound.radius(), {benchFieldOfView, aspect}), centre,
                                    up);
    case BenchViewpoint::Home: { // osgGA::CameraManipulator::computeHomePosition()
        const double side = math::tan(osg::DegreesToRadians(0.5 * benchFieldOfView)) * std::min(1.0, aspect);
        const double away = bound.radius() / math::sin(math::atan(side));
        return osg::Matrixd::lookAt(centre - osg::Vec3d(0.0, away, 0.0), centre, up);
    }
    case BenchViewpoint::Inside:
        break;
    }
    const osg::Vec3d eye(centre.x(), centre.y(), 1.7);
    return osg::Matrixd::lookAt(eye, eye + osg::Vec3d(0.0, 10.0, 0.5), up);
}

BenchView runBenchView(const std::string& name, const std::function<ForestDescription()>& make,
                       BenchViewpoint viewpoint, bool inFull, const BenchSettings& settings,
                       BenchDriver& driver) {
    const auto context = valueOrThrow(
        createOffscreenContext(settings.size.width, settings.size.height, settings.profile), Failed);
    BenchView result;
    result.forest = name;
    result.viewpoint = viewpoint;
    const osg::ref_ptr<Forest> forest = makeForest(make, result);
    inFull = inFull && forest->getInstanced();
    const BenchScene tree = createBenchScene(stageOfInstances(), 1);
    const osg::Matrixd view = viewOf(forest->getBound(), viewpoint, settings.size);
    std::vector<BenchVariant> variants = {{forest, view},
                                          {tree.forest, benchView(settings.size, tree.still->getBound())}};
    enum { Drawn, Tree, Full };
    if (inFull) {
        ForestDescription description = make();
        description.drawing.tiers = false;
        variants.push_back({new Forest(std::move(description)), view});
    }
    BenchViewer viewer(settings.size, *context, driver, variants, 3 * (warmUpRounds + settings.frames));
    const BenchClock clock;
    viewer.draw(Drawn, 0.0);
    result.firstFrameSeconds = clock.seconds();
    const BenchWinds winds;
    double time = 0.0;
    for (int round = -warmUpRounds; round < settings.frames; ++round) {
        throwIfAny(tree.forest->setWind(winds.at(round + warmUpRounds)));
        time += settings.step;
        for (const int variant : {Drawn, Tree})
            if (round < 0)
                viewer.draw(variant, time);
            else
                viewer.measure(variant, time);
        if (inFull && round == -1)
            viewer.draw(Full, time);
        if (inFull && round >= 0 && round % BenchView::roundsPerFull == 0)
            viewer.measure(Full, time);
    }
    if (forest->getInstanced())
        result.tiers = instancedTrees(*forest->getInstanced()).treesByTier();
    std::vector<BenchTimes> times = viewer.times(Tree, time);
    result.drawn = std::move(times[Drawn]);
    result.tree = std::move(times[Tree]);
    if (inFull)
        result.inFull = std::move(times[Full]);
    return result;
}

std::vector<BenchView> runBenchScale(const std::vector<int>& trees, const BenchSettings& settings,
                                     BenchDriver& driver) {
    const auto ownBytes = [](const BenchView& forest) {
        return forest.forestBytes - static_cast<double>(forest.archetypeBytes);
    };
    BenchView few;
    for (int i = 0; i < 2; ++i) { // the second run has all memory that forests share
        few = {};
        makeForest([] { return createWood(fewTrees); }, few);
    }
    std::vector<BenchView> results;
    for (const int count : trees) {
        results.push_back(runBenchView(
            "made trees", [=] { return createWood(static_cast<std::size_t>(count)); }, BenchViewpoint::Over,
            false, settings, driver));
        if (BenchView& wood = results.back(); wood.trees > fewTrees)
            wood.bytesPerTree = (ownBytes(wood) - ownBytes(few)) / static_cast<double>(wood.trees - fewTrees);
    }
    return results;
}
