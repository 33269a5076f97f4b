// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchRun.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

using namespace osgTreeWind;

namespace {

class CountVisitor : public osg::NodeVisitor {
public:
    using osg::NodeVisitor::apply;
    CountVisitor() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
    void apply(osg::Node& node) override {
        ++counts.nodes;
        traverse(node);
    }
    void apply(osg::Camera& node) override {
        apply(static_cast<osg::Node&>(node));
    } // cameras of render passes are not transforms
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

BenchCounts count(const BenchStage& stage, const BenchScene& scene, int trees) {
    CountVisitor visitor;
    scene.moving->accept(visitor);
    BenchCounts counts = visitor.counts;
    const auto times = static_cast<std::uint64_t>(trees);
    const TreeCounts perTree = countTree(*scene.model);
    counts.units = times * perTree.units;
    if (stage.geometry <= BenchStage::BUFFERED_LINES) {
        counts.vertices = times * perTree.skeletonPoints;
        counts.lines =
            times * perTree.units * static_cast<std::uint64_t>(scene.model->skeleton.ringsPerBranch - 1);
    } else {
        counts.vertices = times * perTree.totalVertices();
        counts.triangles = times * perTree.totalTriangles();
    }
    return counts;
}

std::string anglesOf(const BenchScene& scene) {
    if (!scene.forest)
        return "recorded";
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
    BenchViewer viewer(settings.size, *context, driver, {{scene.moving, view}, {scene.still, view}},
                       2 * (settings.warmUp + settings.frames));
    const BenchWinds winds;
    double time = 0.0;
    for (int pair = 0; pair < settings.warmUp + settings.frames; ++pair) {
        if (scene.forest)
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
    scene.moving->setNodeMask(~0u);
    result.counts = count(stage, scene, trees);
    return result;
}
