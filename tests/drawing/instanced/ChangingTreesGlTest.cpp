// SPDX-License-Identifier: MIT
#include <tests/FullTests.h>
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/gpu/PosePage.h>
#include <osgTreeWind/motion/MovingForest.h>

#include <osg/ContextData>
#include <osg/DisplaySettings>
#include <osg/Texture>

#include <cstdlib>
#include <deque>
#include <iostream>
#include <new>

using namespace osgTreeWind;

namespace {

thread_local std::size_t allocations = 0;

} // namespace

// Not inlined: GCC would report new and free() as mismatched.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size))
        return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
#endif

namespace {

/// Counts allocations during the cull of its children.
class CullMeter : public osg::Group {
public:
    std::size_t allocated = 0; ///< Number of allocations in the last cull.

    void traverse(osg::NodeVisitor& visitor) override {
        const std::size_t before = allocations;
        osg::Group::traverse(visitor);
        if (visitor.getVisitorType() == osg::NodeVisitor::CULL_VISITOR)
            allocated = allocations - before;
    }
};

/// A place in a grid with a spacing of `apart` metres.
TreePlacement placement(std::size_t number, double apart) {
    TreePlacement tree;
    tree.position = {apart * double(number % 16), apart * double(number / 16), 0.0};
    tree.heading = 0.7f * static_cast<float>(number % 9);
    tree.size.height = 5.0f;
    tree.size.crownWidth = 4.0f;
    tree.seed = static_cast<std::uint32_t>(number);
    return tree;
}

ForestDescription squareForest(std::size_t count, double apart) {
    ForestDescription description = smallForest(0);
    for (std::size_t i = 0; i < count; ++i)
        description.trees.push_back(placement(i, apart));
    return description;
}

class ChangingTreesGlTest : public GlTest {
protected:
    static constexpr int width = 64, height = 48;

    void show(osg::Node* scene, const osg::Vec3& eye, const osg::Vec3& at) {
        open(width, height);
        viewer().setSceneData(scene);
        osg::Camera& camera = *viewer().getCamera();
        camera.setProjectionMatrixAsPerspective(40, double(width) / height, 1, 1000);
        camera.setViewMatrixAsLookAt(eye, at, osg::Z_AXIS);
    }
    osg::ref_ptr<osg::Image> later(int first, int last) {
        for (int i = first; i <= last; ++i)
            frame(i / 25.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
};

} // namespace

// OSGTREEWIND_CHURN_FRAMES=10000 makes a long run.
TEST_F(ChangingTreesGlTest, ThousandTreesPerSecondAreAddedAndRemoved) {
    const char* wanted = std::getenv("OSGTREEWIND_CHURN_FRAMES");
    const int frames = wanted ? std::atoi(wanted) : casesToRun(400, 100);
    ForestDescription description = squareForest(200, 2.0);
    description.drawing.full = 20.0f;
    description.drawing.reduced = 12.0f;
    description.drawing.impostor = 8.0f;
    osg::ref_ptr<Forest> forest = new Forest(description);
    show(forest, osg::Vec3(16, -25, 8), osg::Vec3(16, 16, 2));
    std::deque<TreeId> trees;
    for (std::size_t tree = 0; tree < 200; ++tree)
        trees.push_back(TreeId(tree));
    std::size_t settled = 0, number = 200;
    for (int i = 0; i < frames; ++i) {
        for (int k = 0; k < 20; ++k) { // 500 trees per second are added and 500 removed
            trees.push_back(forest->addTree(placement(number++ % 256, 2.0)).value());
            ASSERT_TRUE(forest->removeTree(trees.front()).empty());
            ASSERT_FALSE(forest->removeTree(trees.front()).empty()) << "it was already removed";
            trees.pop_front();
            ASSERT_TRUE(
                forest->changeTree(trees[static_cast<std::size_t>(k)], placement(number % 251, 2.0)).empty());
        }
        frame(i / 25.0);
        ASSERT_FALSE(HasFailure()) << "frame " << i;
        if (i == frames / 2)
            settled = residentMemory();
        if (wanted && i % 500 == 499)
            std::cout << "frame " << i + 1 << ": " << residentMemory() / 1000 << " kB" << std::endl;
    }
    EXPECT_EQ(forest->getNumTrees(), 200u);
    for (const TreeId tree : trees)
        EXPECT_TRUE(forest->getSimulation().holds(tree));
    EXPECT_LE(movingForest(forest->getSimulation()).trees().size(), 201u)
        << "slots of removed trees are reused";
    EXPECT_LE(instancedTrees(*forest->getInstanced()).nearTreeCount(), 201u);
    EXPECT_LT(residentMemory(), settled + keptMemory);
    EXPECT_GT(covered(image()), 0.02);
}

// Sanitizers delay the release of memory.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(ChangingTreesGlTest, DrawingAFrameRepeatedlyNeedsNoMoreMemory) {
    osg::ref_ptr<Forest> forest = new Forest(squareForest(200, 2.0));
    show(forest, osg::Vec3(16, -25, 8), osg::Vec3(16, 16, 2));
    frame(0.0);
    const auto listed = instancedTrees(*forest->getInstanced()).treesByTier();
    std::size_t settled = 0;
    for (int i = 0; i < 200; ++i) {
        viewer().renderingTraversals();
        if (i == 50)
            settled = residentMemory();
    }
    EXPECT_EQ(instancedTrees(*forest->getInstanced()).treesByTier(), listed);
    EXPECT_LT(residentMemory(), settled + (1u << 20));
}

TEST_F(ChangingTreesGlTest, CullDoesNotAllocatePerTree) {
    std::size_t allocated[2];
    for (const bool many : {false, true}) {
        ForestDescription description = squareForest(many ? 60 : 2, many ? 0.1 : 2.0);
        description.drawing.tiers = false;
        osg::ref_ptr<CullMeter> meter = new CullMeter;
        meter->addChild(new Forest(description));
        show(meter, osg::Vec3(1, -25, 8), osg::Vec3(1, 0, 2));
        later(0, 8);
        allocated[many] = meter->allocated;
    }
    EXPECT_EQ(allocated[0], allocated[1]);
    EXPECT_LE(allocated[0], 4u) << "OSG allocates for its list of stages";
}
#endif

TEST_F(ChangingTreesGlTest, AddedSpeciesLooksLikeAnInitialOne) {
    ForestDescription description = squareForest(16, 2.0);
    description.drawing.full = 20.0f;
    description.drawing.reduced = 12.0f;
    description.drawing.impostor = 8.0f;
    Species red = smallSpecies();
    red.name = "red";
    red.tree.wood.childrenPerBranch = 2;
    red.appearance.leaves = {0.5f, 0.02f, 0.02f};
    ForestDescription both = description;
    both.species.push_back(red);
    for (std::size_t i = 0; i < 16; i += 3)
        both.trees[i].species = 1;
    const osg::Vec3 eyes[] = {{16, -12, 4}, {16, -60, 8}};
    for (const osg::Vec3& eye : eyes) {
        osg::ref_ptr<Forest> forest = new Forest(description);
        show(forest, eye, osg::Vec3(16, 10, 2));
        osg::ref_ptr<osg::Image> before = later(0, 0);
        const Result<std::size_t> index = forest->addSpecies(red);
        ASSERT_TRUE(index) << toString(index.problems());
        for (const std::size_t i : {0, 3, 6, 9, 12, 15})
            ASSERT_TRUE(forest->changeTree(TreeId(i), both.trees[i]).empty());
        osg::ref_ptr<osg::Image> after = later(1, 1);
        EXPECT_GT(difference(*before, *after).mean, 0.1);
        show(new Forest(both), eye, osg::Vec3(16, 10, 2));
        EXPECT_LT(difference(*after, *later(0, 1)).mean, 0.05);
    }
}

TEST_F(ChangingTreesGlTest, VertexArrayObjectsDrawTheSamePictures) {
    osg::ref_ptr<osg::DisplaySettings> settings = osg::DisplaySettings::instance();
    ForestDescription description = squareForest(16, 2.0);
    description.drawing.full = 20.0f;
    description.drawing.reduced = 12.0f;
    description.drawing.impostor = 8.0f;
    osg::ref_ptr<osg::Image> pictures[2][2];
    for (const bool objects : {false, true}) {
        settings->setVertexBufferHint(objects ? osg::DisplaySettings::VERTEX_ARRAY_OBJECT
                                              : osg::DisplaySettings::NO_PREFERENCE);
        osg::ref_ptr<Forest> forest = new Forest(description);
        show(forest, osg::Vec3(16, -12, 4), osg::Vec3(16, 10, 2));
        pictures[objects][0] = later(0, 5);
        viewer().getCamera()->setViewMatrixAsLookAt(osg::Vec3(16, -40, 4), osg::Vec3(16, 10, 2), osg::Z_AXIS);
        pictures[objects][1] = later(6, 10); // other tiers reuse the draws
        settings->setVertexBufferHint(osg::DisplaySettings::NO_PREFERENCE);
    }
    for (const int i : {0, 1}) {
        EXPECT_GT(covered(*pictures[0][i]), 0.02);
        EXPECT_EQ(difference(*pictures[0][i], *pictures[1][i]).mean, 0.0) << i;
    }
}

TEST_F(ChangingTreesGlTest, RecreatesTexturesThatOpenGLLost) {
    osg::ref_ptr<Forest> forest = new Forest(squareForest(16, 2.0));
    show(forest, osg::Vec3(16, -12, 4), osg::Vec3(16, 10, 2));
    osg::ref_ptr<osg::Image> before = later(0, 5);
    osg::get<osg::TextureObjectManager>(context().getState()->getContextID())->discardAllGLObjects();
    EXPECT_EQ(difference(*later(5, 5), *before).mean, 0.0);
}

TEST_F(ChangingTreesGlTest, PosesAreCorrectOnEveryPage) {
    // One camera sees all trees, the other one only the last ones.
    constexpr std::size_t trees = PosePage::maxTrees + 200;
    ForestDescription description = squareForest(trees, 1.0);
    description.species[0].tree.wood.levels = 1;
    for (TreePlacement& tree : description.trees)
        tree.leaves = 0.0f;
    description.drawing.tiers = false;
    constexpr float last = trees / 16.0f; // row
    const osg::Vec3 eye(8, last - 17, 4), at(8, last - 1, 2);
    osg::ref_ptr<Forest> few = new Forest(description);
    show(few, eye, at);
    osg::ref_ptr<osg::Image> expected = later(0, 1);
    ASSERT_GT(covered(*expected), 0.2);
    EXPECT_LT(instancedTrees(*few->getInstanced()).treesByTier()[0], 1000u);

    osg::ref_ptr<Forest> all = new Forest(description);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    osg::ref_ptr<osg::Camera> overview = new osg::Camera;
    overview->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    overview->setRenderOrder(osg::Camera::PRE_RENDER);
    overview->setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    overview->attach(osg::Camera::COLOR_BUFFER, GL_RGBA);
    overview->setViewport(0, 0, 16, 16);
    overview->setProjectionMatrixAsOrtho(-600, 600, -600, 600, 1, 1000);
    overview->setViewMatrixAsLookAt(osg::Vec3(8, 0.5f * last, 500), osg::Vec3(8, 0.5f * last, 0),
                                    osg::Y_AXIS);
    overview->addChild(all);
    scene->addChild(overview);
    scene->addChild(all);
    show(scene, eye, at);
    osg::ref_ptr<osg::Image> picture = later(0, 1);
    EXPECT_GE(instancedTrees(*all->getInstanced()).treesByTier()[0], trees);
    EXPECT_EQ(difference(*picture, *expected).mean, 0.0);
}
