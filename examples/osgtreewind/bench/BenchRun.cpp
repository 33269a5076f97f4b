// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchRun.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

using namespace osgTreeWind;

namespace {

std::string anglesOf(const BenchScene& scene) {
    const BranchwiseForest* branchwise = scene.forest->getBranchwise();
    return !branchwise || branchwise->getAngleSource() == BranchwiseForest::GPU_ANGLES ? "gpu" : "cpu";
}

} // namespace

BenchResult runBench(const BenchStage& stage, int trees, const BenchSettings& settings, BenchDriver& driver) {
    const auto context = valueOrThrow(
        createOffscreenContext(settings.size.width, settings.size.height, settings.profile), Failed);
    enum { Moving, Still };
    const BenchScene scene = createBenchScene(stage, trees);
    const osg::Matrixd view = benchView(settings.size, scene.still->getBound());
    BenchViewer viewer(settings.size, *context, driver, {{scene.forest, view}, {scene.still, view}},
                       2 * (settings.warmUp + settings.frames));
    const BenchWinds winds;
    double time = 0.0;
    for (int pair = 0; pair < settings.warmUp + settings.frames; ++pair) {
        throwIfAny(scene.forest->setWind(winds.at(pair)));
        time += settings.step;
        for (const int variant : {Moving, Still})
            if (pair < settings.warmUp)
                viewer.draw(variant, time);
            else
                viewer.measure(variant, time);
    }

    BenchResult result;
    result.stage = stage;
    result.trees = trees;
    std::vector<BenchTimes> times = viewer.times(Still, time);
    result.moving = std::move(times[Moving]);
    result.still = std::move(times[Still]);
    result.angles = anglesOf(scene);
    return result;
}
