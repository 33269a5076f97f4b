// SPDX-License-Identifier: MIT
#include <tests/MessageCollector.h>
#include <tests/nodes/Culling.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/FunctionWind.h>

#include <osg/LOD>
#include <osg/MatrixTransform>
#include <osg/Switch>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

using namespace osgTreeWind;

namespace {

/// A wind that depends on the place and blows diagonally.
WindFieldPtr gradient() {
    return std::make_shared<FunctionWind>([](const glm::vec3& place, double) {
        return glm::vec3(6.0f + 0.05f * place.x, 4.0f - 0.03f * place.y, 0.2f);
    });
}

ForestDescription forestInWind(const WindFieldPtr& wind) {
    ForestDescription description = smallForest(6);
    description.wind = wind;
    description.wind.frame = WindFrame::Scene;
    return description;
}

glm::vec2 leanOf(const Forest& forest, std::size_t tree) {
    return movingForest(forest.getSimulation()).modal()->lean(tree);
}

osg::ref_ptr<osg::MatrixTransform> placeBelow(const osg::Matrix& place, osg::Node* node) {
    osg::ref_ptr<osg::MatrixTransform> transform = new osg::MatrixTransform(place);
    transform->addChild(node);
    return transform;
}

} // namespace

TEST(ForestPlaceTest, BelowATransformTreesMoveAsIfPlacedThere) {
    const double turn = 0.9;
    const osg::Matrix place =
        osg::Matrix::rotate(turn, osg::Z_AXIS) * osg::Matrix::translate(40.0, -25.0, 3.0);
    ForestDescription planted = forestInWind(gradient());
    for (TreePlacement& tree : planted.trees) {
        const osg::Vec3d at = osg::Vec3d(tree.position.x, tree.position.y, tree.position.z) * place;
        tree.position = {at.x(), at.y(), at.z()};
        tree.heading += static_cast<float>(turn);
    }
    osg::ref_ptr<Forest> there = new Forest(planted), moved = new Forest(forestInWind(gradient())),
                         elsewhere = new Forest(forestInWind(gradient()));
    osg::ref_ptr<osg::Node> scene = placeBelow(place, moved);
    updateFrames(*there, 1, 50);
    updateFrames(*scene, 1, 50);
    updateFrames(*elsewhere, 1, 50);
    const auto sine = static_cast<float>(std::sin(turn)), cosine = static_cast<float>(std::cos(turn));
    for (std::size_t tree = 0; tree < 6; ++tree) {
        const glm::vec2 lean = leanOf(*moved, tree);
        const glm::vec2 turned(cosine * lean.x - sine * lean.y, sine * lean.x + cosine * lean.y);
        EXPECT_LT(glm::distance(turned, leanOf(*there, tree)), 2e-4f) << tree;
        EXPECT_GT(glm::distance(leanOf(*elsewhere, tree), leanOf(*there, tree)), 5e-3f)
            << "the test needs a wind that depends on the place";
    }
}

TEST(ForestPlaceTest, FarFromTheWorldOriginTheSceneMayBeLocalOrWorld) {
    ForestDescription description = forestInWind(gradient()); // in scene coordinates
    description.origin = {4.3e5, 4.5e6, 1402.0};
    for (TreePlacement& tree : description.trees)
        tree.position += description.origin;
    osg::ref_ptr<Forest> local = new Forest(description), world = new Forest(description);
    osg::ref_ptr<osg::Node> scene = placeBelow(osg::Matrix::translate(world->getOrigin()), world);
    updateFrames(*local, 1, 30);
    updateFrames(*scene, 1, 30);
    for (std::size_t tree = 0; tree < 6; ++tree) {
        EXPECT_LT(glm::distance(leanOf(*local, tree), leanOf(*world, tree)), 1e-5f) << tree;
        EXPECT_GT(glm::length(leanOf(*local, tree)), 0.01f);
    }
}

TEST(ForestPlaceTest, AMovingForestSamplesTheWindAtItsCurrentPlace) {
    const auto wall = std::make_shared<FunctionWind>(
        [](const glm::vec3& place, double) { return glm::vec3(place.x > 100.0f ? 9.0f : 3.0f, 0.0f, 0.0f); });
    osg::ref_ptr<Forest> forest = new Forest(forestInWind(wall));
    osg::ref_ptr<osg::MatrixTransform> ship = placeBelow(osg::Matrix(), forest);
    updateFrames(*ship, 1, 20);
    EXPECT_NEAR(windsOf(*forest).front().x, 3.0f, 0.1f);
    ship->setMatrix(osg::Matrix::rotate(osg::PI, osg::Z_AXIS) * osg::Matrix::translate(200, 0, 0));
    updateFrames(*ship, 21, 25);
    EXPECT_NEAR(windsOf(*forest).front().x, -9.0f, 0.1f) << "turned with the ship, in the forest's axes";
}

TEST(ForestPlaceTest, ASecondPlaceGivesOneWarning) {
    osg::ref_ptr<Forest> forest = new Forest(forestInWind(gradient()));
    forest->setName("park");
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(placeBelow(osg::Matrix::translate(0, 0, 0), forest));
    scene->addChild(placeBelow(osg::Matrix::translate(500, 0, 0), forest));
    const ScopedMessages messages;
    updateFrames(*scene, 1, 20);
    const std::string warnings = messages.take();
    EXPECT_NE(warnings.find("forest \"park\" stands in two places"), std::string::npos) << warnings;
    EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 1) << warnings;
    osg::ref_ptr<Forest> first = new Forest(forestInWind(gradient()));
    updateFrames(*first, 1, 20);
    EXPECT_EQ(leanOf(*first, 3), leanOf(*forest, 3)) << "the wind of the first place";
}

TEST(ForestPlaceTest, TwoViewsOfOnePlaceGiveNoWarning) {
    osg::ref_ptr<Forest> forest = new Forest(forestInWind(gradient()));
    osg::ref_ptr<osg::Node> scene = placeBelow(osg::Matrix::translate(20, 0, 0), forest);
    const ScopedMessages messages;
    for (unsigned frame = 1; frame < 10; ++frame)
        for (int view = 0; view < 2; ++view)
            update(*scene, frame, frame / 25.0);
    EXPECT_EQ(messages.take(), "");
}

TEST(ForestPlaceTest, ItPausesBelowASwitchThatIsOff) {
    osg::ref_ptr<Forest> forest = new Forest(forestInWind(gradient()));
    osg::ref_ptr<osg::Switch> choice = new osg::Switch;
    choice->addChild(placeBelow(osg::Matrix(), forest), true);
    updateFrames(*choice, 1, 20);
    const std::vector<glm::vec4> held = statesOf(*forest);
    choice->setAllChildrenOff();
    updateFrames(*choice, 21, 60);
    EXPECT_EQ(statesOf(*forest), held);
    choice->setAllChildrenOn();
    updateFrames(*choice, 61, 61);
    EXPECT_NE(statesOf(*forest), held);
    for (const glm::vec4& state : statesOf(*forest))
        EXPECT_TRUE(std::isfinite(state.x) && std::abs(state.x) < 2.0f)
            << "the time below the Switch does not count";
}

TEST(ForestPlaceTest, ItMovesIfOneOfTwoSwitchesIsOn) {
    osg::ref_ptr<Forest> forest = new Forest(forestInWind(gradient()));
    osg::ref_ptr<osg::Switch> off = new osg::Switch, on = new osg::Switch;
    off->addChild(forest, false);
    on->addChild(forest, true);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(off);
    scene->addChild(on);
    updateFrames(*scene, 1, 20);
    EXPECT_GT(glm::length(leanOf(*forest, 0)), 0.01f);
}

TEST(ForestPlaceTest, ItPausesBelowALodThatStoppedShowingIt) {
    osg::ref_ptr<Forest> forest = new Forest(forestInWind(gradient()));
    osg::ref_ptr<osg::LOD> lod = new osg::LOD;
    lod->addChild(forest, 0.0f, 100.0f);
    updateFrames(*lod, 1, 10);
    EXPECT_GT(glm::length(leanOf(*forest, 0)), 0.001f) << "without a viewer it moves";
    const auto run = [&](unsigned first, unsigned last, double distance) {
        for (unsigned frame = first; frame <= last; ++frame) {
            update(*lod, frame, frame / 25.0);
            cull(*lod, frame, osg::Vec3d(0, -distance, 2));
        }
    };
    run(11, 20, 30.0);
    const std::vector<glm::vec4> seen = statesOf(*forest);
    run(21, 24, 1000.0);
    const std::vector<glm::vec4> held = statesOf(*forest);
    EXPECT_NE(seen, held) << "for another few frames";
    run(25, 60, 1000.0);
    EXPECT_EQ(statesOf(*forest), held);
    run(61, 62, 30.0);
    run(63, 63, 30.0);
    EXPECT_NE(statesOf(*forest), held) << "seen again";
}

TEST(ForestPlaceTest, AJumpInTimeCountsAsAtMostOneSecond) {
    osg::ref_ptr<Forest> jumped = new Forest(forestInWind(gradient())),
                         walked = new Forest(forestInWind(gradient()));
    updateFrames(*jumped, 1, 20);
    updateFrames(*walked, 1, 20);
    update(*jumped, 21, 20 / 25.0 + 3600.0);
    update(*walked, 21, 20 / 25.0 + ForestSimulation::maxStep);
    for (std::size_t tree = 0; tree < 6; ++tree)
        EXPECT_LT(glm::distance(leanOf(*jumped, tree), leanOf(*walked, tree)), 1e-5f);
}
