// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchStage.h>

#include <examples/osgtreewind/bench/BenchWood.h>
#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/branchwise/TreeDrawable.h>
#include <osgTreeWind/wind/GridWind.h>

#include <osg/Geometry>
#include <osgUtil/IntersectionVisitor>

#include <limits>

using namespace osgTreeWind;

namespace {

constexpr double spacing = 6.0; // metres

ForestDescription benchForest(const BenchStage& stage, int trees) {
    Species reference;
    reference.name = "reference";
    reference.shapes = 1;
    if (stage.geometry != BenchStage::BARK_AND_LEAVES)
        reference.tree.leaves.clustersPerBranch = 0;
    ForestDescription description;
    description.species = {reference};
    description.law = stage.law();
    description.drawing.tiers = stage.method != BenchStage::INSTANCES_IN_FULL;
    for (int i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.position = placeInRows(static_cast<std::size_t>(i), static_cast<std::size_t>(trees), spacing);
        tree.seed = static_cast<std::uint32_t>(i);
        description.trees.push_back(tree);
    }
    return description;
}

osg::ref_ptr<osg::Geometry> emptyLines(bool buffered) {
    osg::ref_ptr<osg::Geometry> lines = new osg::Geometry;
    lines->setUseDisplayList(false);
    lines->setUseVertexBufferObjects(buffered);
    lines->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    osg::ref_ptr<osg::Vec4Array> brown = new osg::Vec4Array;
    brown->push_back({0.40f, 0.33f, 0.27f, 1.0f});
    lines->setColorArray(brown, osg::Array::BIND_OVERALL);
    return lines;
}

/// Centre lines of `count` units, starting with `first`.
osg::ref_ptr<osg::Geometry> unitLines(const Skeleton& skeleton, std::size_t first, std::size_t count,
                                      bool buffered) {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    osg::ref_ptr<osg::DrawArrayLengths> strips = new osg::DrawArrayLengths(GL_LINE_STRIP);
    for (std::size_t unit = first; unit < first + count; ++unit) {
        for (int ring = 0; ring < skeleton.ringsPerBranch; ++ring)
            points->push_back(toOsg(skeleton.point(unit, ring)));
        strips->push_back(skeleton.ringsPerBranch);
    }
    osg::ref_ptr<osg::Geometry> lines = emptyLines(buffered);
    lines->setVertexArray(points);
    lines->addPrimitiveSet(strips);
    return lines;
}

void drawLinesInsteadOfBark(Forest& forest, const Skeleton& skeleton, bool buffered) {
    std::vector<osg::ref_ptr<osg::Geometry>> lines;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        lines.push_back(unitLines(skeleton, unit, 1, buffered));
    for (unsigned i = 0; i < forest.getNumTrees(); ++i) {
        TreeNode& tree = *branchwiseTrees(*forest.getBranchwise()).nodes()[i];
        osgUtil::IntersectionVisitor picking; // makes the tree create its transforms
        tree.traverse(picking);
        for (unsigned unit = 0; unit < tree.getNumBranches(); ++unit) {
            BranchTransform& branch = *tree.getBranch(unit);
            for (unsigned child = 0; child < branch.getNumChildren(); ++child)
                if (dynamic_cast<SkinDrawable*>(branch.getChild(child)))
                    branch.setChild(child, lines[unit]);
        }
    }
}

constexpr float always = std::numeric_limits<float>::infinity();
constexpr TreeLodRanges alwaysFull{always, always};

osg::ref_ptr<osg::Group> stillTrees(const BenchStage& stage, const PlacedForest& forest,
                                    const std::shared_ptr<const TreeModel>& model) {
    osg::ref_ptr<TreeBuffers> buffers = new TreeBuffers(model);
    const TreeStyle style = makeTreeStyle(forest.description().species.front().appearance);
    const bool lined = stage.geometry <= BenchStage::BUFFERED_LINES;
    osg::ref_ptr<osg::Geometry> lines;
    if (lined)
        lines = unitLines(model->skeleton, 0, model->skeleton.units.size(),
                          stage.geometry == BenchStage::BUFFERED_LINES);
    osg::ref_ptr<osg::Group> group = new osg::Group;
    for (const PlacedTree& tree : forest.trees) {
        osg::ref_ptr<osg::PositionAttitudeTransform> node;
        if (lined) {
            node = new osg::PositionAttitudeTransform;
            node->addChild(lines);
        } else {
            osg::ref_ptr<TreeNode> still = new TreeNode(buffers, style, tree.scale);
            still->getLod()->setRanges(alwaysFull);
            node = still;
        }
        node->setPosition(toOsg(tree.position));
        group->addChild(node);
    }
    return group;
}

} // namespace

const std::vector<BenchStage>& benchStages() {
    using S = BenchStage;
    constexpr auto lines = S::BUFFERED_LINES, leaves = S::BARK_AND_LEAVES;
    constexpr auto method = S::BRANCHWISE;
    constexpr auto cpu = BranchwiseForest::CPU_ANGLES, gpu = BranchwiseForest::GPU_ANGLES;
    static const std::vector<BenchStage> stages = {
        {"cpu", "skeletons, angles on the CPU", S::LINES, method, "6.1", {10, 5, 3, 2}, cpu},
        {"cpu-vbo",
         "skeletons in vertex buffers, angles on the CPU",
         lines,
         method,
         "6.2",
         {12, 5, 3, 2},
         cpu},
        {"gpu",
         "skeletons in vertex buffers, angles on the GPU",
         lines,
         method,
         "6.3",
         {105, 60, 40, 31},
         gpu},
        {"gpu-skin", "bark, angles on the GPU", S::BARK, method, "6.4", {90, 45, 36, 31}, gpu},
        {"gpu-leaves",
         "bark and a transform per leaf, angles on the GPU",
         leaves,
         method,
         "6.5",
         {32, 14, 9, 7},
         gpu},
        {"resident", "instances and tiers, law modal", leaves, S::INSTANCES},
        {"resident-full", "instances without tiers, law modal", leaves, S::INSTANCES_IN_FULL},
    };
    return stages;
}

BenchScene createBenchScene(const BenchStage& stage, int trees) {
    const ForestDescription description = benchForest(stage, trees);
    const PlacedForest placed(description);
    BenchScene scene;
    const std::shared_ptr<const TreeModel>& model = placed.models().front();
    scene.still = stillTrees(stage, placed, model);
    scene.forest = new Forest(description);
    if (BranchwiseForest* forest = scene.forest->getBranchwise()) {
        forest->setAngleSource(stage.angles);
        throwIfAny(forest->setLodRanges(alwaysFull));
        if (stage.geometry <= BenchStage::BUFFERED_LINES)
            drawLinesInsteadOfBark(*scene.forest, model->skeleton,
                                   stage.geometry == BenchStage::BUFFERED_LINES);
    }
    return scene;
}

BenchWinds::BenchWinds() {
    constexpr int side = 64; // cells of 1 m
    for (const float turn : {1.0f, -1.0f}) {
        Random random(7);
        std::vector<float> values;
        for (int cell = 0; cell < side * side; ++cell) {
            const float speed = 4.0f * turn + random.symmetric();
            values.insert(values.end(), {speed, 0.0f, 0.3f * speed});
        }
        _winds[turn < 0.0f] =
            GridWind::fromForestWind(side, side, std::move(values), {-8.0, side - 8.0, 0.0}).value();
    }
}
