// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/MakeCanopyMap.h>
#include <osgTreeWind/wind/SwingingWind.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace osgTreeWind;

namespace {

CanopyTree treeAt(float x, float y) {
    CanopyTree tree;
    tree.place = {x, y};
    tree.height = 20.0f;
    tree.frontalArea = 40.0f;
    tree.crownArea = 12.0f;
    tree.drag.fill(1.5f);
    tree.streamlining = 0.5f;
    tree.breezeStreamlining = 0.3f;
    return tree;
}

/// 240 m by 240 m around the origin.
std::vector<CanopyTree> plantation(float spacing = 4.0f) {
    std::vector<CanopyTree> trees;
    for (float x = -120.0f; x <= 120.0f; x += spacing)
        for (float y = -120.0f; y <= 120.0f; y += spacing)
            trees.push_back(treeAt(x, y));
    return trees;
}

float shelterOf(const CanopySample& stand, float speed) {
    return CanopySpeedStep(speed).mix(stand.shelter);
}
float shelterOf(const CanopyMap& map, float speed) {
    return shelterOf(map.at({0.0f, 0.0f}, speed), speed);
}

/// Momentum absorbed by the trees on a square metre with this shelter, over rho u*^2.
double balance(const CanopySample& stand, float speed, double trees) {
    double taken = 0.0, pressure = 0.0;
    for (std::size_t i = 0; i < CanopyTree::layers; ++i) {
        const float z = 20.0f * (static_cast<float>(i) + 0.5f) / static_cast<float>(CanopyTree::layers);
        const SwingingWind wind(stand.profile.mean(z), stand.profile.spread(z), stand.profile.skewness(z));
        pressure += static_cast<double>(wind.meanPressure()) / static_cast<double>(CanopyTree::layers);
    }
    const double felt = static_cast<double>(shelterOf(stand, speed) * speed);
    const double typical =
        felt * std::sqrt(pressure); // speed for streamlining: u^-0.5 from 10 m/s on, u^-0.3 below
    const double left = typical < 10.0 ? std::pow(std::max(typical, 1.6) / 10.0, -0.3)
                                       : std::pow(std::min(typical, 25.0) / 10.0, -0.5);
    taken = trees * 1.5 * static_cast<double>(CanopyTree::layers) * pressure * felt * felt * left;
    const double friction = static_cast<double>(stand.profile.friction * speed);
    return taken / (friction * friction);
}

TEST(MakeCanopyMap, AClosedStandAbsorbsTheMomentumFlux) {
    const auto map = makeCanopyMap(plantation());
    for (const float speed : {4.0f, 8.0f, 16.0f, 24.0f, 40.0f}) {
        const CanopySample stand = map->at({0.0f, 0.0f}, speed);
        EXPECT_EQ(stand.closure, 1.0f);
        EXPECT_LT(shelterOf(stand, speed), 1.0f);
        EXPECT_NEAR(balance(stand, speed, 1.0 / 16.0), 1.0, 0.055) << speed;
    }
    EXPECT_GT(shelterOf(*map, 40.0f), shelterOf(*map, 8.0f))
        << "streamlined crowns let the wind penetrate deeper";
}

TEST(MakeCanopyMap, HasTheFrontalAreaAndHeightOfTheStand) {
    const CanopySample stand = makeCanopyMap(plantation())->at({0.0f, 0.0f}, 5.0f);
    const CanopyProfile wanted = CanopyProfile::ofStand(20.0f, 40.0f / 16.0f);
    EXPECT_NEAR(stand.profile.height, 20.0f, 1e-3f);
    EXPECT_NEAR(stand.profile.attenuation / wanted.attenuation, 1.0f, 0.03f);
}

TEST(MakeCanopyMap, HasTheCrownCover) {
    EXPECT_NEAR(makeCanopyMap(plantation())->crownCoverAt({1.0f, 2.0f}), 12.0f / 16.0f, 0.03f);
    EXPECT_EQ(makeCanopyMap(plantation(3.0f))->crownCoverAt({1.0f, 2.0f}), 1.0f)
        << "crowns of 12 m^2 on 9 m^2 each";
    EXPECT_NEAR(makeCanopyMap(plantation())->crownCoverAt({121.0f, 0.0f}), 0.5f * 12.0f / 16.0f, 0.06f)
        << "the edge";
    EXPECT_LT(makeCanopyMap({treeAt(0.0f, 0.0f)})->crownCoverAt({0.0f, 0.0f}), 0.02f) << "alone";
    EXPECT_EQ(makeCanopyMap(plantation())->crownCoverAt({1.0e4f, 0.0f}), 0.0f);
    const auto everywhere = makeUniformCanopyMap({treeAt(0.0f, 0.0f)}, 20.0f, 40.0f / 16.0f);
    EXPECT_NEAR(everywhere->crownCoverAt({5.0f, 7.0f}), 12.0f / 16.0f, 1e-5f);
}

TEST(MakeCanopyMap, ASingleTreeHasTheOpenWind) {
    const auto map = makeCanopyMap({treeAt(0.0f, 0.0f)});
    for (float angle = 0.0f; angle < 6.3f; angle += 0.1f) {
        const glm::vec2 upwind = map->fetch * glm::vec2(std::cos(angle), std::sin(angle));
        EXPECT_LT(map->at(upwind, 5.0f).closure, 0.01f) << angle;
    }
}

TEST(MakeCanopyMap, AGapIsOpenAndAnEdgeIsHalfOpen) {
    std::vector<CanopyTree> trees;
    for (const CanopyTree& tree : plantation())
        if (tree.place.x < -60.0f || tree.place.x > 60.0f)
            trees.push_back(tree);
    const auto map = makeCanopyMap(trees);
    EXPECT_EQ(map->at({0.0f, 0.0f}, 5.0f).closure, 0.0f);
    EXPECT_EQ(map->at({-100.0f, 0.0f}, 5.0f).closure, 1.0f);
    EXPECT_LT(map->at({-60.0f, 0.0f}, 5.0f).profile.attenuation,
              map->at({-90.0f, 0.0f}, 5.0f).profile.attenuation);
}

TEST(MakeCanopyMap, AThinStandSheltersLess) {
    EXPECT_GT(shelterOf(*makeCanopyMap(plantation(12.0f)), 8.0f),
              1.5f * shelterOf(*makeCanopyMap(plantation(4.0f)), 8.0f));
}

TEST(MakeCanopyMap, NoTreesMakeOpenCountryAndDistantTreesFitIntoMemory) {
    EXPECT_EQ(makeCanopyMap({})->at({0.0f, 0.0f}, 5.0f).closure, 0.0f);
    const auto map = makeCanopyMap({treeAt(-1e5f, -1e5f), treeAt(1e5f, 1e5f)});
    EXPECT_LE(map->cells.size(), std::size_t(1) << 20);
}

/// Expects the same canopy in a part of a world as in the whole.
void expectSame(const CanopyMap& part, const CanopyMap& whole, const glm::vec2& place) {
    const CanopySample a = part.at(place, 9.0f), b = whole.at(place, 9.0f);
    EXPECT_EQ(a.closure, b.closure);
    EXPECT_EQ(a.profile.height, b.profile.height);
    EXPECT_EQ(a.profile.friction, b.profile.friction);
    EXPECT_EQ(a.topSpeedRatio, b.topSpeedRatio);
    EXPECT_EQ(a.shelter, b.shelter);
}

TEST(MakeCanopyMap, APartOfAForestHasTheCanopyOfTheWholeToTheBit) {
    std::vector<CanopyTree> trees = plantation();
    for (CanopyTree& tree : trees) // irregular, like a forest
        tree.height += 4.0f * std::sin(tree.place.x) + 2.0f * std::sin(0.01f * tree.place.y);
    for (float x = 500.0f; x < 800.0f; x += 7.0f)
        trees.push_back(treeAt(x, 33.3f));
    const CanopySettings canopy = withCanopyStatistics({}, {trees}, trees.size());
    EXPECT_NEAR(canopy.reach, 40.0, 4.0) << "twice the mean height";
    std::vector<CanopyTree> around;
    for (const CanopyTree& tree : trees)
        if (static_cast<double>(std::abs(tree.place.x)) < shelterReach(canopy))
            around.push_back(tree);
    ASSERT_LT(around.size(), trees.size());
    std::reverse(around.begin(), around.end());
    const auto whole = makeCanopyMap(trees, canopy), part = makeCanopyMap(around, canopy);
    for (float y = -150.0f; y < 150.0f; y += 11.0f)
        expectSame(*part, *whole, {0.0f, y});
    EXPECT_EQ(part->usual.profile.height, whole->usual.profile.height);
    EXPECT_EQ(part->usual.profile.friction, whole->usual.profile.friction);
}

TEST(MakeCanopyMap, KnowsTheExtentOfAForest) {
    const std::vector<CanopyTree> trees = plantation();
    EXPECT_NEAR(makeCanopyMap(trees)->extent, 244.0f, 50.0f) << "stands at edges are thinner";
    EXPECT_NEAR(withCanopyStatistics({}, {trees}, 4 * trees.size()).extent, 488.0, 100.0)
        << "these are a quarter of the trees";
    CanopySettings canopy;
    canopy.extent = 3000.0;
    EXPECT_EQ(makeCanopyMap(trees, canopy)->extent, 3000.0f);
    EXPECT_EQ(withCanopyStatistics(canopy, {trees}, trees.size()).extent, 3000.0);
}

TEST(MakeCanopyMap, AGivenStandIsEndlessUnlessItsExtentIsGiven) {
    const auto topSpeed = [](double extent) {
        CanopySettings canopy;
        canopy.source = CanopySource::Given;
        canopy.extent = extent;
        const auto map = makeCanopyMap({treeAt(0.0f, 0.0f)}, canopy);
        map->setReference(60.0f);
        return map->usual.topSpeedRatio;
    };
    EXPECT_EQ(topSpeed(0.0), CanopyProfile::ofStand(20.0f, 2.0f).topSpeedRatio(60.0f, 1e9f));
    EXPECT_LT(topSpeed(0.0), topSpeed(2000.0));
    EXPECT_LT(topSpeed(2000.0), topSpeed(1.0));
}

TEST(MakeCanopyMap, AUniformCanopyIsTheSameEverywhere) {
    const auto map = makeUniformCanopyMap({treeAt(0.0f, 0.0f)}, 20.0f, 2.5f);
    const CanopySample here = map->at({0.0f, 0.0f}, 8.0f), there = map->at({1e6f, -1e6f}, 8.0f);
    EXPECT_EQ(here.shelter, there.shelter);
    EXPECT_NEAR(shelterOf(here, 8.0f), shelterOf(*makeCanopyMap(plantation()), 8.0f), 0.01f);
}

} // namespace
