// SPDX-License-Identifier: MIT
#include <tests/Folders.h>
#include <tests/FullTests.h>
#include <tests/gl/GlTest.h>

#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseTrees.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/gpu/branchwise/ForestAnglePasses.h>
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/system/Program.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <osg/GLExtensions>
#include <osgDB/Registry>
#include <osgViewer/CompositeViewer>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

namespace osgTreeWind {
namespace {

/// A leafless species with few vertices.
Species bareSpecies(int levels, int children, int trunkUnits) {
    Species species;
    species.name = "bare";
    species.shapes = 1;
    species.tree.wood.levels = levels;
    species.tree.wood.childrenPerBranch = children;
    species.tree.wood.trunkUnits = trunkUnits;
    species.tree.wood.bareUnits = 15;
    species.tree.wood.ringsPerBranch = 2;
    species.tree.leaves.clustersPerBranch = 0;
    species.wood.elasticModulus = 1e5f; // makes the trunk move too
    return species;
}

ForestDescription forestOf(const Species& species, std::size_t trees, MotionLaw law = MotionLaw::Thesis) {
    ForestDescription forest;
    forest.species.push_back(species);
    forest.law = law;
    for (std::size_t i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.position = {5.0 * static_cast<double>(i % 100), 5.0 * static_cast<double>(i / 100), 0.0};
        tree.heading = 0.37f * static_cast<float>(i);
        tree.seed = static_cast<std::uint32_t>(i);
        forest.trees.push_back(tree);
    }
    // The wind differs between any two branches.
    forest.wind = std::make_shared<FunctionWind>([](const glm::vec3& p, double time) {
        return glm::vec3(std::sin(1.7f * p.x + 3.1f * p.z + static_cast<float>(time) + 1.0f),
                         std::cos(2.3f * p.y - 1.3f * p.z), 0.1f * std::sin(p.x * p.y));
    });
    return forest;
}

/// Makes a camera draw everything outside its viewport.
void drawOutsideViewport(osg::Camera& camera) {
    camera.setViewMatrixAsLookAt({0, -1e5, 0}, {0, -2e5, 0}, osg::Z_AXIS);
    camera.setCullingMode(osg::CullSettings::NO_CULLING);
}

float largestDifference(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
    float largest = 0.0f;
    for (std::size_t i = 0; i < a.size(); ++i)
        largest = std::max({largest, std::abs(a[i].x - b[i].x), std::abs(a[i].y - b[i].y)});
    return largest;
}

class GpuForestGlTest : public GlTest {
protected:
    /// Starts a forest with GPU angles; the frame of the probe is over. It is drawn outside the viewport.
    osg::ref_ptr<Forest> start(ForestDescription description) {
        given = description;
        osg::ref_ptr<Forest> forest = new Forest(std::move(description));
        forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
        open(16, 16);
        viewer().setSceneData(forest);
        drawOutsideViewport(*viewer().getCamera());
        frame(0.0);
        frame(0.0);
        EXPECT_EQ(forest->getBranchwise()->getAngleSource(), BranchwiseForest::GPU_ANGLES);
        return forest;
    }

    /// Largest difference between the branch states of GPU and CPU after frames of 1/60 s.
    float cpuDifferenceAfter(int frames, const ForestDescription& description) {
        osg::ref_ptr<Forest> forest = start(description);
        ForestSimulation oracle(given);
        oracle.advance(0.0);
        for (int i = 1; i <= frames; ++i) {
            frame(i / 60.0);
            oracle.advance(i / 60.0);
        }
        frame(frames / 60.0);
        return largestDifference(movingForest(forest->getSimulation()).branches()->states(),
                                 movingForest(oracle).branches()->states());
    }

    ForestDescription given;
};

struct TexelCase {
    const char* name;
    Species species;
    std::size_t trees, units;
};

TEST_F(GpuForestGlTest, EveryBranchGetsItsOwnWindValue) {
    for (const TexelCase& c : {TexelCase{"one unit", bareSpecies(0, 1, 1), 1, 1},
                               TexelCase{"seven units", bareSpecies(1, 6, 1), 1, 7},
                               TexelCase{"64 reference trees", bareSpecies(4, 3, 2), 64, 122 * 64},
                               TexelCase{"300,000 units", bareSpecies(8, 3, 2), 31, 9842 * 31}}) {
        osg::ref_ptr<Forest> forest = start(forestOf(c.species, c.trees));
        ForestSimulation oracle(given);
        ASSERT_EQ(movingForest(oracle).branches()->states().size(), c.units) << c.name;
        oracle.advance(0.0);
        for (int i = 1; i <= 3; ++i) {
            frame(i / 60.0);
            oracle.advance(i / 60.0);
        }
        frame(3.0 / 60.0); // reads back the third step
        float moved = 0.0f;
        for (const glm::vec4& state : movingForest(oracle).branches()->states())
            moved = std::max(moved, std::abs(state.x));
        EXPECT_GT(moved, 1e-4f) << c.name;
        EXPECT_LT(largestDifference(movingForest(forest->getSimulation()).branches()->states(),
                                    movingForest(oracle).branches()->states()),
                  5e-4f)
            << c.name;
    }
}

TEST_F(GpuForestGlTest, WindReachesTransformsOneFrameLater) {
    ForestDescription calm = forestOf(bareSpecies(1, 3, 1), 1);
    calm.wind = nullptr;
    osg::ref_ptr<Forest> forest = start(calm);
    const auto windTexel = [&] {
        return reinterpret_cast<const float*>(
            anglePasses(*forest->getBranchwise())->wind()->getImage()->data())[0];
    };
    BranchTransform* branch = branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getBranch(1);
    frame(0.1);
    frame(0.2);
    EXPECT_EQ(windTexel(), 0.0f);

    EXPECT_TRUE(forest->setWind(std::make_shared<UniformWind>(glm::vec3(9.0f, 0.0f, 0.0f))).empty());
    frame(0.3); // frame N
    EXPECT_NE(windTexel(), 0.0f);
    EXPECT_TRUE(branch->getRotation().zeroRotation());
    frame(0.4); // frame N + 1
    EXPECT_FALSE(branch->getRotation().zeroRotation());
}

TEST_F(GpuForestGlTest, AgreesWithTheCpuOverSixHundredFrames) {
    for (const MotionLaw law : {MotionLaw::Thesis, MotionLaw::ThesisSmooth}) {
        const float difference = cpuDifferenceAfter(600, forestOf(bareSpecies(4, 3, 2), 4, law));
        RecordProperty("difference" + std::to_string(static_cast<int>(law)), std::to_string(difference));
        EXPECT_LT(difference, 1e-3f) << static_cast<int>(law);
    }
}

TEST_F(GpuForestGlTest, ExampleForestAgreesWithTheCpu) {
    auto example = readForestFile(OSGTREEWIND_SOURCE_DIR "/examples/forest.treewind");
    ASSERT_TRUE(example);
    example.value().law = MotionLaw::ThesisSmooth;
    const float difference = cpuDifferenceAfter(casesToRun(600, 120), example.value());
    RecordProperty("difference", std::to_string(difference));
    EXPECT_LT(difference, 1e-3f);
}

TEST_F(GpuForestGlTest, BothKindsOfNoiseMoveLeavesAsOnTheCpu) {
    for (const std::optional<float> exponent : {std::optional<float>(), std::optional<float>(1.5f)}) {
        ForestDescription description = forestOf(bareSpecies(2, 3, 1), 2, MotionLaw::ThesisSmooth);
        description.species[0].tree.leaves.clustersPerBranch = 4;
        description.noiseExponent = exponent;
        osg::ref_ptr<Forest> forest = start(description);
        ForestSimulation oracle(description);
        oracle.advance(0.0);
        for (int i = 1; i <= 30; ++i) {
            frame(i / 60.0);
            oracle.advance(i / 60.0);
        }
        frame(30.0 / 60.0);
        ASSERT_FALSE(movingForest(oracle).branches()->leafStates().empty());
        EXPECT_GT(std::abs(movingForest(oracle).branches()->leafStates()[0].x), 1e-3f);
        EXPECT_LT(largestDifference(movingForest(forest->getSimulation()).branches()->leafStates(),
                                    movingForest(oracle).branches()->leafStates()),
                  5e-4f);
        EXPECT_LT(largestDifference(movingForest(forest->getSimulation()).branches()->states(),
                                    movingForest(oracle).branches()->states()),
                  5e-4f);
    }
}

TEST_F(GpuForestGlTest, ContinuesFromReadBackStatesAfterAContextLoss) {
    osg::ref_ptr<Forest> forest = start(forestOf(bareSpecies(2, 3, 1), 2));
    for (int i = 1; i <= 30; ++i)
        frame(i / 60.0);
    const std::vector<glm::vec4> before = movingForest(forest->getSimulation()).branches()->states();
    forest->releaseGLObjects();
    open(16, 16);
    viewer().setSceneData(forest);
    frame(31 / 60.0);
    frame(32 / 60.0);
    float moved = 0.0f;
    for (const glm::vec4& state : before)
        moved = std::max(moved, std::abs(state.x));
    EXPECT_GT(moved, 0.1f);
    EXPECT_LT(largestDifference(movingForest(forest->getSimulation()).branches()->states(), before),
              0.2f * moved);
}

TEST_F(GpuForestGlTest, StatesStayTheSameDuringAPause) {
    osg::ref_ptr<Forest> forest = start(forestOf(bareSpecies(2, 3, 1), 2));
    for (int i = 1; i <= 5; ++i)
        frame(i / 60.0);
    frame(5.0 / 60.0);
    const std::vector<glm::vec4> held = movingForest(forest->getSimulation()).branches()->states();
    for (int i = 0; i < 5; ++i)
        frame(5.0 / 60.0);
    EXPECT_EQ(movingForest(forest->getSimulation()).branches()->states(), held);
}

TEST_F(GpuForestGlTest, TwoViewsTakeOneStepPerFrame) {
    given = forestOf(bareSpecies(2, 3, 1), 2);
    osg::ref_ptr<Forest> forest = new Forest(given);
    forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
    open(32, 16);
    viewer().setSceneData(nullptr);
    osgViewer::CompositeViewer composite;
    composite.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    for (int i = 0; i < 2; ++i) {
        osg::ref_ptr<osgViewer::View> view = new osgViewer::View;
        view->getCamera()->setGraphicsContext(&context());
        view->getCamera()->setViewport(16 * i, 0, 16, 16);
        view->setSceneData(forest);
        composite.addView(view);
    }
    composite.realize();
    ForestSimulation oracle(given);
    oracle.advance(0.0);
    composite.frame(0.0);
    composite.frame(0.0);
    for (int i = 1; i <= 10; ++i) {
        composite.frame(i / 60.0);
        oracle.advance(i / 60.0);
    }
    composite.frame(10.0 / 60.0);
    EXPECT_EQ(forest->getBranchwise()->getAngleSource(), BranchwiseForest::GPU_ANGLES);
    EXPECT_LT(largestDifference(movingForest(forest->getSimulation()).branches()->states(),
                                movingForest(oracle).branches()->states()),
              5e-4f);
}

TEST_F(GpuForestGlTest, HostileWindLeavesFiniteAnglesThatRecover) {
    struct Hostile : WindField {
        explicit Hostile(float v) : value(v) {}
        glm::vec3 velocity(const WindPlace&, double) const override { return glm::vec3(value); }
        float value;
    };
    for (const MotionLaw law : {MotionLaw::Thesis, MotionLaw::ThesisSmooth}) {
        ForestDescription description = forestOf(bareSpecies(2, 3, 1), 1, law);
        const WindFieldPtr sane = description.wind.field;
        osg::ref_ptr<Forest> forest = start(description);
        double time = 0.0;
        for (const float value :
             {std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity(),
              std::numeric_limits<float>::quiet_NaN(), 1e30f, -1e30f, 1e-42f}) {
            EXPECT_TRUE(forest->setWind(std::make_shared<Hostile>(value)).empty());
            frame(time += 0.02);
            EXPECT_TRUE(forest->setWind(sane).empty());
            frame(time += 0.02);
            frame(time += 0.02);
            for (const glm::vec4& state : movingForest(forest->getSimulation()).branches()->states()) {
                ASSERT_TRUE(std::isfinite(state.x) && std::isfinite(state.y)) << value;
                ASSERT_LE(std::max(std::abs(state.x), std::abs(state.y)), 1.5708f) << value;
            }
        }
    }
}

TEST_F(GpuForestGlTest, FallsBackToTheCpuWithoutFloatTargets) {
    osg::ref_ptr<Forest> forest = new Forest(forestOf(bareSpecies(2, 3, 1), 1));
    forest->getBranchwise()->setAngleSource(BranchwiseForest::CPU_ANGLES);
    open(16, 16);
    viewer().setSceneData(forest);
    frame(0.0);
    auto* extensions = context().getState()->get<osg::GLExtensions>();
    const float version = extensions->glslLanguageVersion;
    extensions->glslLanguageVersion = 1.2f;
    forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
    for (int i = 1; i <= 4; ++i)
        viewer().frame(i / 60.0);
    extensions->glslLanguageVersion = version;
    const std::string messages = takeMessages();
    EXPECT_NE(messages.find("angles come from the CPU"), std::string::npos);
    EXPECT_EQ(messages.find("angles come from the CPU"), messages.rfind("angles come from the CPU"));
    EXPECT_EQ(forest->getBranchwise()->getAngleSource(), BranchwiseForest::CPU_ANGLES);
    EXPECT_NE(movingForest(forest->getSimulation()).branches()->states()[1].x, 0.0f);
}

TEST_F(GpuForestGlTest, LeafTransformsStandWhereTheShaderDrawsLeaves) {
    Species species;
    species.tree.wood.levels = 2;
    osg::ref_ptr<Forest> forest = start(forestOf(species, 1));
    const float always = std::numeric_limits<float>::infinity();
    EXPECT_TRUE(forest->getBranchwise()->setLodRanges({always, always}).empty());
    for (int i = 1; i <= 6; ++i)
        frame(i / 30.0);
    struct Leaves : osg::NodeVisitor {
        Leaves() : osg::NodeVisitor(TRAVERSE_ALL_CHILDREN) {}
        void apply(osg::MatrixTransform& node) override {
            if (!dynamic_cast<BranchTransform*>(&node))
                matrices.push_back(osg::computeLocalToWorld(getNodePath()));
            traverse(node);
        }
        std::vector<osg::Matrix> matrices;
    } leaves;
    branchwiseTrees(*forest->getBranchwise()).nodes()[0]->accept(leaves);
    const PosedTree& tree = *branchwiseTrees(*forest->getBranchwise()).nodes()[0]->getPosedTree();
    ASSERT_EQ(leaves.matrices.size(), tree.model().leaves.size());
    std::vector<osg::Vec3> expected, found;
    glm::vec3 corners[verticesPerLeafCluster];
    float fluttering = 0.0f;
    for (std::size_t leaf = 0; leaf < leaves.matrices.size(); ++leaf) {
        tree.leafPoints(leaf, corners);
        expected.push_back(
            osg::Matrix::rotate(
                osg::Quat(movingForest(forest->getSimulation()).trees()[0].heading, osg::Z_AXIS))
                .preMult(toOsg(corners[2])));
        found.push_back(toOsg(tree.model().leafMesh[2].corner) * leaves.matrices[leaf]);
        fluttering = std::max(
            fluttering, std::abs(movingForest(forest->getSimulation()).branches()->leafStates()[leaf].x));
    }
    EXPECT_GT(fluttering, 1e-3f);
    for (const osg::Vec3& point : found) { // transforms are in scene order, leaves in access order
        float nearest = 1e9f;
        for (const osg::Vec3& other : expected)
            nearest = std::min(nearest, (other - point).length());
        ASSERT_LT(nearest, 1e-4f);
    }
}

TEST_F(GpuForestGlTest, AddingAndRemovingForestsDoesNotLeakMemory) {
    const int forests = casesToRun(1000, 150);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    open(16, 16);
    viewer().setSceneData(scene);
    std::size_t settled = 0;
    for (int i = 0; i < forests; ++i) {
        osg::ref_ptr<Forest> forest = new Forest(forestOf(bareSpecies(1, 2, 1), 1));
        forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
        scene->addChild(forest);
        for (int n = 0; n < 3; ++n)
            frame(0.02 * n);
        scene->removeChild(forest);
        if (i == forests * 3 / 10)
            settled = residentMemory();
    }
    EXPECT_LT(residentMemory(), settled + keptMemory);
}

TEST_F(GpuForestGlTest, BrokenShaderFileIsReplacedByTheEmbeddedOne) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("otw-shaders-" + std::to_string(processId()));
    std::filesystem::create_directories(folder / "branchwise");
    std::ofstream(folder / "branchwise" / "branch_angles.frag")
        << "#version 330 compatibility\nvoid main() { nonsense; }\n";
    osgDB::FilePathList& paths = osgDB::Registry::instance()->getDataFilePathList();
    paths.push_front(folder.string());
    osg::ref_ptr<Forest> forest = new Forest(forestOf(bareSpecies(2, 3, 1), 1));
    forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
    open(16, 16);
    viewer().setSceneData(forest);
    for (int i = 0; i < 5; ++i)
        viewer().frame(i / 60.0);
    paths.pop_front();
    std::filesystem::remove_all(folder);
    const std::string messages = takeMessages();
    EXPECT_NE(messages.find("nonsense"), std::string::npos) << "the driver's log";
    EXPECT_NE(messages.find("the embedded shaders are used instead"), std::string::npos);
    EXPECT_NE(movingForest(forest->getSimulation()).branches()->states()[1].x, 0.0f);
}

} // namespace
} // namespace osgTreeWind
