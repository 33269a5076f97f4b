// SPDX-License-Identifier: MIT
#include <tests/wind/Winds.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindFiles.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace osgTreeWind {
namespace {

constexpr double quarter = 1.5707963267948966;

/// Returns the place as velocity: x, y and the height above the ground.
class PlaceWind : public WindField {
public:
    glm::vec3 velocity(const WindPlace& place, double) const override {
        return {place.position.x, place.position.y, place.height};
    }
};

glm::dmat4 moved(const glm::dvec3& by) {
    return glm::translate(glm::dmat4(1.0), by);
}
glm::dmat4 turned(double angle, const glm::dvec3& about = {0, 0, 1}) {
    return glm::rotate(glm::dmat4(1.0), angle, about);
}

WindFieldPtr gusts() {
    Wind wind(std::make_shared<UniformWind>(glm::vec3(7.0f, 2.0f, 0.0f), LogProfile{10.0, 0.1}));
    wind.gusts.intensity = 0.2;
    return asField(wind);
}

TEST(LayeredWind, IdentityTransformChangesNothing) {
    const WindFieldPtr world = gusts();
    const LayeredWind same = sampler(world, glm::dmat4(1.0));
    for (int i = 1; i < 50; ++i) {
        const float x = 13.37f * static_cast<float>(i);
        const WindPlace place({x, -2.0f * x, 0.1f * x}, 0.02f * x);
        EXPECT_EQ(same.velocity(place, 0.3 * i), world->velocity(place, 0.3 * i));
    }
}

TEST(LayeredWind, SamplesAtTheTransformedPlace) {
    const LayeredWind wind = sampler(std::make_shared<PlaceWind>(), moved({100, 20, 5}) * turned(quarter));
    // 3 m along the frame's x axis is 3 m north; the velocity is returned in the frame's axes.
    const glm::vec3 v = wind.velocity({{3, 0, 9}, 2}, 0.0);
    EXPECT_NEAR(v.x, 23.0f, 1e-4f) << "the frame's x is north";
    EXPECT_NEAR(v.y, -100.0f, 1e-4f) << "the frame's -y is east";
    EXPECT_NEAR(v.z, 7.0f, 1e-5f) << "the height above the ground is unchanged";
}

TEST(LayeredWind, TurnsVelocitiesWithoutScaling) {
    const WindFieldPtr world = std::make_shared<UniformWind>(glm::vec3(6, 0, 0));
    const LayeredWind wind =
        sampler(world, moved({5, 5, 5}) * turned(quarter) * glm::scale(glm::dmat4(1.0), {2.0, 2.0, 4.0}));
    EXPECT_LT(glm::distance(wind.velocity({1, 2, 3}, 0.0), glm::vec3(0, -6, 0)), 1e-5f);
    const LayeredWind tilted = sampler(world, turned(quarter, {0, 1, 0}));
    EXPECT_LT(glm::distance(tilted.velocity({1, 2, 3}, 0.0), glm::vec3(0, 0, 6)), 1e-5f);
}

TEST(LayeredWind, ScalesHeightsWithPlaces) {
    const LayeredWind wind =
        sampler(std::make_shared<PlaceWind>(), glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
    EXPECT_EQ(wind.velocity({{3, 4, 9}, 2}, 0.0), glm::vec3(6, 8, 14));
}

TEST(LayeredWind, SampleEqualsVelocity) {
    const LayeredWind wind = sampler(gusts(), moved({300, -50, 12}) * turned(0.7));
    std::vector<WindPlace> places;
    for (int i = 0; i < 150; ++i)
        places.emplace_back(glm::vec3(i, 2 * i, 5 + i % 7), 1.0f);
    std::vector<glm::vec3> out(places.size());
    wind.sample(places.data(), places.size(), 4.5, out.data());
    for (std::size_t i = 0; i < places.size(); ++i)
        EXPECT_EQ(out[i], wind.velocity(places[i], 4.5)) << i;
}

TEST(LayeredWind, KeepsFloatPrecisionFarFromTheOrigin) {
    const LayeredWind wind = sampler(std::make_shared<PlaceWind>(), moved({1.0e6, -1.0e6, 0}));
    const glm::vec3 v = wind.velocity({{12.3f, 4.5f, 30.25f}, 0.0f}, 0.0);
    EXPECT_NEAR(v.x, 1.0e6f + 12.3f, 0.04f) << "floats have a spacing of 0.06 m there";
    EXPECT_NEAR(v.y, -1.0e6f + 4.5f, 0.04f);
    EXPECT_EQ(v.z, 30.25f);
}

TEST(LayeredWind, DegenerateMatrixDoesNotTurn) {
    const LayeredWind wind = sampler(std::make_shared<UniformWind>(glm::vec3(1, 2, 3)), glm::dmat4(0.0));
    EXPECT_EQ(wind.velocity({4, 5, 6}, 0.0), glm::vec3(1, 2, 3));
    EXPECT_EQ(sampler(nullptr).velocity({1, 2, 3}, 0.0), glm::vec3(0.0f));
}

TEST(LayeredWind, ReplacingTheFieldDropsFilesAndMap) {
    Wind wind(std::make_shared<UniformWind>(glm::vec3(1, 2, 3)));
    WindFiles known;
    known.map = DataTransform();
    known.files = {"a.asc"};
    setKnown(wind, known);
    EXPECT_TRUE(filesOf(wind));
    EXPECT_TRUE(filesOf(Wind(wind))) << "a copy";
    EXPECT_TRUE(mapOf(wind));
    wind.field = std::make_shared<UniformWind>(glm::vec3(4, 5, 6));
    EXPECT_FALSE(filesOf(wind));
    EXPECT_FALSE(mapOf(wind));
}

TEST(LayeredWind, TurnedForestLeansLikeTurnedTrees) {
    const glm::dmat4 frame = moved({40, 70, 3}) * turned(quarter);
    ForestDescription upright;
    upright.species = {defaultSpecies()};
    upright.trees.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
        upright.trees[i].position = {10.0 * static_cast<double>(i), 4.0, 0.5 * static_cast<double>(i)};
    ForestDescription world = upright;
    for (TreePlacement& tree : world.trees) {
        tree.position = frame * glm::dvec4(tree.position, 1.0);
        tree.heading = static_cast<float>(quarter);
    }
    world.wind = gusts();
    upright.wind = std::make_shared<LayeredWind>(sampler(world.wind, frame));
    ForestSimulation inFrame(upright), inWorld(world);
    for (int i = 0; i < 300; ++i)
        for (ForestSimulation* simulation : {&inFrame, &inWorld})
            simulation->advance(i / 60.0);
    for (std::size_t tree = 0; tree < 3; ++tree) {
        const glm::vec2 a = movingForest(inFrame).modal()->lean(tree),
                        b = movingForest(inWorld).modal()->lean(tree);
        EXPECT_LT(glm::distance(glm::vec2(-a.y, a.x), b), 1e-3f * glm::length(b)) << tree;
    }
}

} // namespace
} // namespace osgTreeWind
