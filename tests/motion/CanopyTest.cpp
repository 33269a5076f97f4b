// SPDX-License-Identifier: MIT
#include <tests/motion/OneTree.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>

using namespace osgTreeWind;

namespace {

TreePlacement spruceAt(double x, double y) {
    TreePlacement tree;
    tree.position = {x, y, 0.0};
    tree.size.height = 20.0f;
    tree.size.trunkDiameter = 0.24f;
    return tree;
}

/// Spruces every four metres, with the first tree in the middle.
ForestDescription stand(CanopySource source, double reach = 100.0) {
    ForestDescription forest;
    forest.species = {*findSpecies("Sitka spruce")};
    forest.trees.push_back(spruceAt(0.0, 0.0));
    for (double x = -reach; x <= reach; x += 4.0)
        for (double y = -reach; y <= reach; y += 4.0)
            if (x != 0.0 || y != 0.0)
                forest.trees.push_back(spruceAt(x, y));
    forest.wind = std::make_shared<UniformWind>(glm::vec3(12.0f, 0.0f, 0.0f), LogProfile{20.0, 0.05});
    forest.wind.gusts.intensity = 0.2;
    forest.canopy.source = source;
    return forest;
}

/// Mean lean of the first tree over half a minute.
float meanLean(ForestSimulation& simulation) {
    float sum = 0.0f;
    for (int i = 0; i <= 400; ++i) {
        simulation.advance(0.1 * i);
        sum += i > 100 ? movingForest(simulation).modal()->lean(0).x / 300.0f : 0.0f;
    }
    return sum;
}

TEST(Canopy, AStandSheltersItsTrees) {
    ForestSimulation sheltered(stand(CanopySource::Forest)), open(stand(CanopySource::None));
    const float among = meanLean(sheltered);
    EXPECT_GT(among, 0.0f);
    EXPECT_LT(among, 0.5f * meanLean(open));
}

float contactOf(ForestSimulation& simulation) {
    simulation.advance(0.0);
    return movingForest(simulation).modal()->factors(0).contact;
}

TEST(Canopy, CrownsInContactDampEachOther) {
    ForestSimulation closed(stand(CanopySource::Forest)), alone(stand(CanopySource::Forest, 0.0)),
        open(stand(CanopySource::None));
    const float width = movingForest(closed).placed().sizeOf(movingForest(closed).trees()[0]).crownWidth;
    const float share = 0.25f * 3.14159265f * width * width / 16.0f;
    EXPECT_NEAR(contactOf(closed), 0.05f * std::min(share, 1.0f), 0.003f);
    EXPECT_LT(contactOf(alone), 0.001f);
    EXPECT_EQ(contactOf(open), 0.0f);
    for (std::size_t slot = 1; slot < movingForest(closed).trees().size(); ++slot)
        EXPECT_TRUE(closed.removeTree(movingForest(closed).placed().idOf(slot)).empty());
    closed.advance(0.1);
    EXPECT_LT(movingForest(closed).modal()->factors(0).contact, 0.001f) << "its neighbours were removed";
}

TEST(Canopy, ASingleTreeHasTheGivenWind) {
    ForestSimulation alone(stand(CanopySource::Forest, 0.0)), open(stand(CanopySource::None, 0.0));
    EXPECT_NEAR(meanLean(alone) / meanLean(open), 1.0f, 0.02f);
}

TEST(Canopy, RemovedTreesNoLongerShelterTheOthers) {
    ForestSimulation felled(stand(CanopySource::Forest)), alone(stand(CanopySource::Forest, 0.0));
    felled.advance(0.0);
    for (std::size_t slot = 1; slot < movingForest(felled).trees().size(); ++slot)
        ASSERT_TRUE(felled.removeTree(TreeId(slot)).empty());
    felled.reset();
    EXPECT_NEAR(meanLean(felled) / meanLean(alone), 1.0f, 1e-3f);
}

TEST(Canopy, AddedTreesShelterTheOthers) {
    ForestSimulation grown(stand(CanopySource::Forest, 0.0)), sheltered(stand(CanopySource::Forest));
    grown.advance(0.0);
    for (const TreePlacement& tree : stand(CanopySource::Forest).trees)
        if (tree.position != glm::dvec3(0.0)) {
            ASSERT_TRUE(grown.addTree(tree));
        }
    grown.reset();
    EXPECT_NEAR(meanLean(grown) / meanLean(sheltered), 1.0f, 1e-3f);
}

/// A change in a distant part of the forest does not change the wind, even after hours.
TEST(Canopy, GustsDoNotJumpAsTreesComeAndGo) {
    ForestDescription forest = stand(CanopySource::Forest, 40.0);
    const double hours = 7200.0;
    const auto windAt = [&](ForestSimulation& simulation, double time) {
        simulation.advance(time);
        glm::vec3 winds[64];
        movingForest(simulation).modal()->patchWinds(0, winds);
        return winds[0];
    };
    ForestSimulation changed(forest), same(forest);
    for (ForestSimulation* simulation : {&changed, &same})
        windAt(*simulation, hours);
    for (double x = 300.0; x < 400.0; x += 4.0) {
        TreePlacement taller = spruceAt(x, 0.0);
        taller.size.height = 35.0f;
        ASSERT_TRUE(changed.addTree(taller));
    }
    for (int i = 1; i < 20; ++i) {
        const glm::vec3 wind = windAt(same, hours + 0.1 * i);
        EXPECT_LT(glm::length(windAt(changed, hours + 0.1 * i) - wind), 0.26f * glm::length(wind)) << i;
    }
}

/// A source above or among the trees is not reduced by the canopy.
TEST(Canopy, WindSourcesAlsoActWithinTheCanopy) {
    ForestDescription forest = stand(CanopySource::Forest, 40.0);
    WindSource fan; // not deflected by the wind
    fan.kind = WindSource::Kind::Jet;
    fan.position = {0.0, 0.0, 35.0};
    fan.elevation = -glm::half_pi<float>();
    fan.radius = 8.0;
    const WindFieldPtr open = forest.wind.field;
    const auto windIn = [&](const WindFieldPtr& field, std::vector<WindSource> sources) {
        forest.wind.field = field;
        forest.wind.sources = std::move(sources);
        ForestSimulation simulation(forest);
        simulation.advance(0.0);
        glm::vec3 winds[64];
        movingForest(simulation).modal()->patchWinds(0, winds);
        return winds[0];
    };
    const glm::vec3 added = windIn(open, {fan}) - windIn(open, {}), alone = windIn(nullptr, {fan});
    EXPECT_LT(alone.z, -3.0f);
    EXPECT_LT(glm::length(added - alone), 1e-4f);
}

TEST(Canopy, AGivenStandSheltersASingleTree) {
    ForestSimulation given(stand(CanopySource::Given, 0.0)), open(stand(CanopySource::None, 0.0));
    EXPECT_LT(meanLean(given), 0.5f * meanLean(open));
}

TEST(Canopy, BelongsToTheForestAndNotToItsWind) {
    ForestSimulation simulation(stand(CanopySource::Forest, 40.0));
    EXPECT_GT(contactOf(simulation), 0.0f);
    ASSERT_TRUE(simulation.setWind(simulation.description().wind.field).empty());
    EXPECT_EQ(simulation.canopy().source, CanopySource::Forest);
    EXPECT_EQ(simulation.currentDescription().canopy.source, CanopySource::Forest);
    EXPECT_EQ(movingForest(*simulation.cloneAtRest()).canopy().source, CanopySource::Forest);
    CanopySettings invalid;
    invalid.height = -1.0;
    EXPECT_FALSE(simulation.setCanopy(invalid).empty());
    EXPECT_EQ(simulation.canopy().source, CanopySource::Forest) << "nothing has changed";
}

TEST(Canopy, CanBeSwitchedOffAndOn) {
    ForestSimulation simulation(stand(CanopySource::Forest, 40.0));
    const float contact = contactOf(simulation);
    CanopySettings canopy = simulation.canopy();
    canopy.source = CanopySource::None;
    ASSERT_TRUE(simulation.setCanopy(canopy).empty());
    simulation.advance(0.1);
    EXPECT_EQ(movingForest(simulation).modal()->factors(0).contact, 0.0f);
    EXPECT_EQ(movingForest(simulation).modal()->factors(0).shelter, 1.0f);
    canopy.source = CanopySource::Forest;
    ASSERT_TRUE(simulation.setCanopy(canopy).empty());
    simulation.advance(0.2);
    EXPECT_EQ(movingForest(simulation).modal()->factors(0).contact, contact);
}

} // namespace
