// SPDX-License-Identifier: MIT
// A host's technique, which uses public headers only.
#include <osgTreeWind/drawing/ForestTechnique.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/model/Skeleton.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/species/Species.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <tests/nodes/ForestFixtures.h>
#include <tests/plugins/PluginPath.h>

#include <osg/Geometry>
#include <osgDB/ObjectWrapper>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <tests/io/TemporaryFolder.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace host {

using namespace osgTreeWind;

/// Draws each tree as a line from its foot to its top.
class LineTechnique : public ForestTechnique {
public:
    LineTechnique() = default;
    LineTechnique(const LineTechnique& other, const osg::CopyOp& copyop = osg::CopyOp::SHALLOW_COPY)
        : ForestTechnique(other, copyop), _width(other._width) {}
    META_Node(host, LineTechnique)

    void setWidth(float width) { _width = width; }
    float getWidth() const { return _width; }

    void setSimulation(std::shared_ptr<ForestSimulation> simulation) override {
        ForestTechnique::setSimulation(std::move(simulation));
        _points = new osg::Vec3Array;
        _lines = new osg::Geometry;
        _lines->setVertexArray(_points);
        _lines->addPrimitiveSet(new osg::DrawArrays(GL_LINES, 0, 0));
        addChild(_lines);
        placeLines();
    }
    void update(const osg::FrameStamp&, bool moved) override {
        if (moved)
            placeLines();
    }
    void treeChanged(TreeId) override { placeLines(); }
    void releaseGLObjects(osg::State* state = nullptr) const override {
        ++released;
        ForestTechnique::releaseGLObjects(state);
    }

    const osg::Vec3Array& points() const { return *_points; }
    mutable int released = 0;

protected:
    ~LineTechnique() override = default;

private:
    void placeLines() {
        _points->clear();
        const ForestSimulation* trees = getSimulation();
        for (const TreeId tree : trees ? trees->trees() : std::vector<TreeId>()) {
            const Skeleton& wood = trees->skeleton(*trees->modelOf(tree));
            const auto top = std::max_element(wood.units.begin(), wood.units.end(),
                                              [](const auto& a, const auto& b) { return a.tip.z < b.tip.z; });
            const UnitMotion motion =
                trees->unitMotion(tree, static_cast<std::size_t>(top - wood.units.begin()));
            const glm::vec3 tip = motion.pose.apply(trees->scaleOf(tree).axes * top->tip);
            const TreePlacement placement = *trees->placementOf(tree);
            const glm::dvec3 foot = placement.position - trees->description().origin;
            const osg::Quat heading(static_cast<double>(placement.heading), osg::Z_AXIS);
            const osg::Vec3 base(osg::Vec3d(foot.x, foot.y, foot.z));
            _points->push_back(base);
            _points->push_back(base + heading * osg::Vec3(tip.x, tip.y, tip.z));
        }
        static_cast<osg::DrawArrays*>(_lines->getPrimitiveSet(0))
            ->setCount(static_cast<int>(_points->size()));
        _points->dirty();
        _lines->dirtyBound();
    }

    float _width = 1.0f;
    osg::ref_ptr<osg::Vec3Array> _points = new osg::Vec3Array;
    osg::ref_ptr<osg::Geometry> _lines;
};

} // namespace host

REGISTER_OBJECT_WRAPPER(host_LineTechnique, new host::LineTechnique, host::LineTechnique,
                        "osg::Object osg::Node host::LineTechnique") {
    ADD_FLOAT_SERIALIZER(Width, 1.0f);
}

using namespace osgTreeWind;
using host::LineTechnique;

namespace {

const LineTechnique* lineTechnique(const Forest& forest) {
    return dynamic_cast<const LineTechnique*>(forest.getTechnique());
}

/// A forest of three trees, drawn as lines.
osg::ref_ptr<Forest> linedForest() {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    EXPECT_TRUE(forest->setTechnique(new LineTechnique).empty());
    return forest;
}

} // namespace

TEST(ForestTechniqueTest, HostTechniqueReplacesTheDefault) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(3));
    const osg::ref_ptr<ForestTechnique> usual = forest->getTechnique();
    ASSERT_EQ(usual.get(), forest->getInstanced());
    const osg::ref_ptr<LineTechnique> lines = new LineTechnique;
    EXPECT_TRUE(forest->setTechnique(lines).empty());
    EXPECT_EQ(forest->getTechnique(), lines.get());
    EXPECT_EQ(forest->getInstanced(), nullptr);
    EXPECT_TRUE(forest->isOwnChild(lines));
    EXPECT_EQ(forest->getNumChildren(), 1u);
    EXPECT_EQ(usual->getNumParents(), 0u);
    EXPECT_EQ(&forest->getSimulation(), lines->getSimulation());
    EXPECT_TRUE(forest->setTechnique(nullptr).empty());
    EXPECT_NE(forest->getInstanced(), nullptr);
    EXPECT_EQ(lines->getNumParents(), 0u);
}

TEST(ForestTechniqueTest, DrawsMovingAddedAndRemovedTrees) {
    const osg::ref_ptr<Forest> forest = linedForest();
    ASSERT_EQ(lineTechnique(*forest)->points().size(), 6u);
    const osg::Vec3 top = lineTechnique(*forest)->points()[1];
    EXPECT_NEAR(top.z(), 4.6f, 0.3f) << "the highest branch of a tree of 5 m";
    updateFrames(*forest, 1, 30);
    EXPECT_GT(lineTechnique(*forest)->points()[1].x(), top.x() + 0.005f) << "the wind blows toward +x";
    EXPECT_TRUE(forest->removeTree(TreeId(1)).empty());
    EXPECT_EQ(lineTechnique(*forest)->points().size(), 4u);
    TreePlacement late;
    late.position = {50.0, 0.0, 0.0};
    EXPECT_TRUE(forest->addTree(late));
    EXPECT_EQ(lineTechnique(*forest)->points().size(), 6u);
    EXPECT_GT(forest->getBound().center().x() + forest->getBound().radius(), 50.0f);
}

TEST(ForestTechniqueTest, StaysWithANewDescriptionUnderAnyLaw) {
    const osg::ref_ptr<Forest> forest = linedForest();
    const LineTechnique* const lines = lineTechnique(*forest);
    ForestDescription next = smallForest(5);
    next.law = MotionLaw::ThesisSmooth;
    EXPECT_TRUE(forest->setDescription(next).empty());
    EXPECT_EQ(forest->getTechnique(), lines);
    EXPECT_EQ(lines->points().size(), 10u);
    EXPECT_TRUE(forest->setTechnique(nullptr).empty());
    EXPECT_NE(forest->getBranchwise(), nullptr);
}

TEST(ForestTechniqueTest, CopiedForestHasACopyOfTheTechnique) {
    const osg::ref_ptr<Forest> forest = linedForest();
    const osg::ref_ptr<LineTechnique> lines = new LineTechnique;
    lines->setWidth(3.0f);
    EXPECT_TRUE(forest->setTechnique(lines).empty());
    for (const auto flags : {osg::CopyOp::SHALLOW_COPY, osg::CopyOp::DEEP_COPY_ALL}) {
        const osg::ref_ptr<Forest> copy = osg::clone(forest.get(), osg::CopyOp(flags));
        ASSERT_NE(lineTechnique(*copy), nullptr);
        EXPECT_NE(lineTechnique(*copy), lines.get());
        EXPECT_EQ(lineTechnique(*copy)->getWidth(), 3.0f);
        EXPECT_EQ(lineTechnique(*copy)->points().size(), 6u);
        EXPECT_EQ(copy->getNumChildren(), 1u);
        EXPECT_EQ(lineTechnique(*copy)->getSimulation(), &copy->getSimulation());
    }
    EXPECT_EQ(lines->getNumParents(), 1u);
}

TEST(ForestTechniqueTest, SavedForestKeepsTheTechnique) {
    usePluginsOfThisBuild();
    const osg::ref_ptr<Forest> forest = linedForest();
    const osg::ref_ptr<LineTechnique> lines = new LineTechnique;
    lines->setWidth(3.0f);
    EXPECT_TRUE(forest->setTechnique(lines).empty());
    forest->addChild(new osg::Group);
    const TemporaryFolder folder;
    for (const char* extension : {"osgt", "osgb", "osgx"}) {
        const std::string file = folder.path() + "/forest." + extension;
        ASSERT_TRUE(osgDB::writeNodeFile(*forest, file));
        const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(file);
        const auto* back = dynamic_cast<const Forest*>(node.get());
        ASSERT_NE(back, nullptr) << extension;
        ASSERT_NE(lineTechnique(*back), nullptr) << extension;
        EXPECT_EQ(lineTechnique(*back)->getWidth(), 3.0f) << extension;
        EXPECT_EQ(lineTechnique(*back)->points().size(), 6u) << extension;
        EXPECT_EQ(back->getNumChildren(), 2u) << extension;
    }
}

TEST(ForestTechniqueTest, ReceivesReleaseGLObjects) {
    const osg::ref_ptr<Forest> forest = linedForest();
    forest->releaseGLObjects();
    EXPECT_EQ(lineTechnique(*forest)->released, 1);
}

/// Calls no function of its base class.
class ForgetfulTechnique : public ForestTechnique {
public:
    void setSimulation(std::shared_ptr<ForestSimulation>) override {}
    bool stepsItself() const override { return false; }
    void update(const osg::FrameStamp&, bool moved) override { steps += moved; }
    int steps = 0;
};

TEST(ForestTechniqueTest, TreesMoveWithATechniqueThatForgetsItsBaseClass) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    const osg::ref_ptr<ForgetfulTechnique> technique = new ForgetfulTechnique;
    EXPECT_TRUE(forest->setTechnique(technique).empty());
    const std::vector<glm::vec4> rest = statesOf(*forest);
    updateFrames(*forest, 1, 10);
    EXPECT_NE(statesOf(*forest), rest);
    EXPECT_EQ(technique->steps, 9) << "the first frame sets the time";
    EXPECT_TRUE(forest->removeTree(TreeId(0)).empty());
    EXPECT_TRUE(forest->setDescription(smallForest(3)).empty());
    EXPECT_EQ(forest->getNumTrees(), 3u);
    updateFrames(*forest, 11, 20);
    EXPECT_EQ(technique->steps, 18);
}

TEST(ForestTechniqueTest, BaseClassDrawsNothingAndHasNoBranches) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    EXPECT_TRUE(forest->setTechnique(new ForestTechnique).empty());
    const std::vector<glm::vec4> rest = statesOf(*forest);
    updateFrames(*forest, 1, 10);
    EXPECT_NE(statesOf(*forest), rest);
    EXPECT_FALSE(forest->getBound().valid()) << "nothing is drawn";
    const auto branch = forest->branch(TreeId(0), 2);
    ASSERT_FALSE(branch.ok());
    EXPECT_EQ(branch.problems().front().key, "technique");
    EXPECT_EQ(forest->branch(TreeId(0), 1000).problems().front().key, "unit");
    EXPECT_FALSE(forest->releaseBranch(TreeId(0), 2));
}

TEST(ForestTechniqueTest, TechniqueForAnotherLawDrawsNothing) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(2));
    EXPECT_TRUE(forest->setTechnique(new BranchwiseForest).empty());
    ASSERT_NE(forest->getBranchwise(), nullptr);
    EXPECT_EQ(forest->getBranchwise()->getNumTrees(), 0u);
    const std::vector<glm::vec4> rest = statesOf(*forest);
    updateFrames(*forest, 1, 3);
    EXPECT_EQ(forest->getNumTrees(), 2u);
    EXPECT_NE(statesOf(*forest), rest) << "the forest moves them all the same";
}
