// SPDX-License-Identifier: MIT
#include <tests/drawing/branchwise/BranchwiseFixtures.h>
#include <tests/gl/GlTest.h>
#include <tests/gl/ThreadingModels.h>

#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/wind/FunctionWind.h>

#include <osgShadow/ShadowMap>
#include <osgShadow/ShadowedScene>

#include <cmath>

namespace osgTreeWind {
namespace {

/// Trees with equal headings in a uniform wind that changes every frame. The law `thesis` stores the wind in
/// each state, which reveals a copy with states of two frames.
ForestDescription selfCheckingForest() {
    ForestDescription description = smallForest(4);
    description.law = MotionLaw::Thesis;
    for (TreePlacement& tree : description.trees)
        tree.heading = 0.0f;
    description.wind = std::make_shared<FunctionWind>(
        [](const glm::vec3&, double time) { return glm::vec3(1.0f + static_cast<float>(time), 0.0f, 0.0f); });
    return description;
}

class GpuThreadingGlTest : public GlTest,
                           public ::testing::WithParamInterface<osgViewer::ViewerBase::ThreadingModel> {};

TEST_P(GpuThreadingGlTest, ReadsBackCompleteStatesOfThePreviousFrame) {
    osg::ref_ptr<Forest> forest = new Forest(selfCheckingForest());
    forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
    open(16, 16);
    viewer().setSceneData(forest);
    viewer().getCamera()->setViewMatrixAsLookAt({0, -1e5, 0}, {0, -2e5, 0}, osg::Z_AXIS);
    viewer().getCamera()->setCullingMode(osg::CullSettings::NO_CULLING);
    viewer().setThreadingModel(GetParam());
    const double step = 1.0 / 64.0; // exact in float
    for (int i = 1; i <= 600; ++i) {
        frame(i * step);
        const std::vector<glm::vec4>& states = movingForest(forest->getSimulation()).branches()->states();
        for (const glm::vec4& state : states)
            ASSERT_EQ(state.z, states.front().z) << "frame " << i;
        if (i > 4) {
            ASSERT_EQ(states.front().z, 1.0f + static_cast<float>((i - 1) * step)) << "frame " << i;
        }
    }
    viewer().setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
}

INSTANTIATE_TEST_SUITE_P(Models, GpuThreadingGlTest, threadingModels, nameOfModel);

class ShadowedForestGlTest : public GlTest {};

TEST_F(ShadowedForestGlTest, ShadowPassTakesNoExtraStep) {
    if (!hasFixedFunction)
        GTEST_SKIP() << "the shaders of osgShadow::ShadowMap do not compile in a core profile";
    osg::ref_ptr<Forest> plain = new Forest(selfCheckingForest());
    osg::ref_ptr<Forest> forest = new Forest(selfCheckingForest());
    forest->getBranchwise()->setAngleSource(BranchwiseForest::GPU_ANGLES);
    osg::ref_ptr<osgShadow::ShadowedScene> scene = new osgShadow::ShadowedScene(new osgShadow::ShadowMap);
    osg::ref_ptr<osg::LightSource> light = new osg::LightSource;
    light->getLight()->setPosition({1.0f, 0.5f, 2.0f, 0.0f});
    scene->addChild(light);
    scene->addChild(forest);
    open(64, 64);
    viewer().setSceneData(scene);
    const osg::BoundingSphere& bound = forest->getBound();
    viewer().getCamera()->setViewMatrixAsLookAt(bound.center() + osg::Vec3d(0, -60, 10), bound.center(),
                                                osg::Z_AXIS);
    frame(0.0);
    frame(0.0);
    update(*plain, 0, 0.0);
    for (unsigned i = 1; i <= 10; ++i) {
        frame(i / 60.0);
        update(*plain, i, i / 60.0);
    }
    frame(10.0 / 60.0);
    ASSERT_EQ(forest->getBranchwise()->getAngleSource(), BranchwiseForest::GPU_ANGLES);
    const auto& expected = movingForest(plain->getSimulation()).branches()->states();
    for (std::size_t i = 0; i < expected.size(); ++i)
        ASSERT_NEAR(movingForest(forest->getSimulation()).branches()->states()[i].x, expected[i].x, 5e-4f)
            << i;
}

} // namespace
} // namespace osgTreeWind
