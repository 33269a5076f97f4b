// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>

#include <osgTreeWind/base/Luminance.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>

using namespace osgTreeWind;

namespace {

constexpr int width = 640, height = 368; // multiples of 8

/// Trees of several species, 12 m apart, in rows that lead away from the camera.
ForestDescription wood(int trees, bool tiers) {
    ForestDescription forest;
    for (const char* name : {"oak", "Norway spruce", "silver birch", "beech"}) {
        forest.species.push_back(*findSpecies(name));
        forest.species.back().shapes = 1;
    }
    for (int i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.species = static_cast<std::size_t>(i) % forest.species.size();
        tree.position = {14.0 * (i % 3 - 1) + 3.0 * std::sin(7.0 * i), 12.0 * i, 0.0};
        tree.heading = 2.1f * static_cast<float>(i);
        tree.size.height = 13.0f + static_cast<float>(i % 5);
        tree.seed = static_cast<std::uint32_t>(i);
        forest.trees.push_back(tree);
    }
    forest.wind = std::make_shared<UniformWind>(glm::vec3(9.0f, 2.0f, 0.0f));
    forest.drawing.tiers = tiers;
    return forest;
}

using Picture = std::vector<unsigned char>;

/// Mean colours of blocks of 8 x 8 pixels.
std::vector<double> blockMeans(const Picture& picture) {
    std::vector<double> means;
    for (int y = 0; y < height; y += 8)
        for (int x = 0; x < width; x += 8)
            for (int c = 0; c < 3; ++c) {
                double sum = 0.0;
                for (int i = 0; i < 64; ++i)
                    sum += picture[static_cast<std::size_t>(4 * ((y + i / 8) * width + x + i % 8) + c)];
                means.push_back(sum / 64.0);
            }
    return means;
}

double meanDifference(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += std::abs(a[i] - b[i]);
    return sum / static_cast<double>(a.size());
}

double coveredPixels(const Picture& picture) {
    double pixels = 0.0;
    for (std::size_t i = 0; i < picture.size(); i += 4)
        pixels += picture[i] || picture[i + 1] || picture[i + 2];
    return pixels;
}

/// Adds a spruce of wood() whose crown begins at the ground.
void plantSpruce(ForestDescription& forest, float x, float y, float height) {
    TreePlacement tree;
    tree.species = 1;
    tree.position = {x, y, 0.0};
    tree.size.height = height;
    tree.openGrown = true; // hides everything behind it down to the ground
    tree.seed = static_cast<std::uint32_t>(forest.trees.size());
    forest.trees.push_back(tree);
}

class TreeTiersGlTest : public GlTest {
protected:
    void show(const ForestDescription& description, int zoom = 1) {
        _forest = new Forest(description);
        _forest->getOrCreateStateSet()->setDefine("EXPOSURE", "1.0"); // that of the bounds below
        open(zoom * width, zoom * height);
        viewer().setSceneData(_forest);
        viewer().getCamera()->setClearColor(osg::Vec4(0, 0, 0, 1));
        viewer().getCamera()->setProjectionMatrixAsPerspective(40, double(width) / height, 1, 2000);
    }
    Picture pictureFrom(const osg::Vec3d& eye, const osg::Vec3d& center, double time) {
        viewer().getCamera()->setViewMatrixAsLookAt(eye, center, osg::Z_AXIS);
        frame(time);
        return {image().data(), image().data() + 4 * image().s() * image().t()};
    }
    /// Number of drawn trees by tier, for the first `trees` trees of a forest.
    std::vector<std::size_t> listed(ForestDescription forest, std::size_t trees) {
        forest.trees.resize(trees);
        show(forest);
        pictureFrom({0, 0, 1.7}, {0, 20, 3}, 0.0);
        const auto listed = instancedTrees(*_forest->getInstanced()).treesByTier();
        return {listed.begin(), listed.end()};
    }
    osg::ref_ptr<Forest> _forest;
};

} // namespace

TEST_F(TreeTiersGlTest, ForestLooksTheSameWithAndWithoutTiers) {
    for (const osg::Vec3d& eye :
         {osg::Vec3d(0, -60, 3), osg::Vec3d(40, -150, 60), osg::Vec3d(-80, 100, 25)}) {
        std::vector<Picture> pictures;
        for (const bool tiers : {true, false}) {
            show(wood(24, tiers));
            for (int i = 0; i < 8; ++i) // near trees get their full motion in the next frame
                pictureFrom(eye, {0, 140, 8}, i / 30.0);
            pictures.push_back(pictureFrom(eye, {0, 140, 8}, 8 / 30.0));
            if (tiers) {
                const auto listed = instancedTrees(*_forest->getInstanced()).treesByTier();
                EXPECT_GT(listed[static_cast<std::size_t>(Tier::Impostor)], 0u)
                    << "the test draws no impostors";
            }
        }
        EXPECT_LT(meanDifference(blockMeans(pictures[0]), blockMeans(pictures[1])), 3.0);
        // Crowns close in the wind, impostors do not.
        EXPECT_NEAR(coveredPixels(pictures[0]) / coveredPixels(pictures[1]), 1.0, 0.11);
    }
}

TEST_F(TreeTiersGlTest, ForestIsEquallyDenseAtAnyResolution) {
    for (const bool tiers : {false, true}) {
        double covered[2] = {};
        for (const int zoom : {1, 4}) {
            ForestDescription forest = wood(24, tiers);
            for (float* height : {&forest.drawing.full, &forest.drawing.reduced, &forest.drawing.impostor})
                *height *= static_cast<float>(zoom); // keeps the tiers
            show(forest, zoom);
            for (int i = 0; i < 8; ++i)
                pictureFrom({0, -60, 3}, {0, 140, 8}, i / 30.0);
            covered[zoom > 1] =
                coveredPixels(pictureFrom({0, -60, 3}, {0, 140, 8}, 8 / 30.0)) / (zoom * zoom);
        }
        EXPECT_NEAR(covered[0] / covered[1], 1.0, 0.03) << tiers;
    }
}

TEST_F(TreeTiersGlTest, TreeIsEquallyBrightInEveryTier) {
    // Mean luma of the visible pixels of a tree from three sides.
    const auto brightness = [&](const Species& species, double pixels, bool tiers) {
        ForestDescription forest;
        forest.species = {species};
        forest.species.front().shapes = 1;
        forest.trees.resize(1);
        forest.trees.front().size.height = 15.0f;
        forest.drawing.tiers = tiers;
        show(forest, 2);
        viewer().setLightingMode(osg::View::SKY_LIGHT);
        viewer().getLight()->setPosition(osg::Vec4(0.5f, -0.5f, 0.7f, 0.0f));
        viewer().getLight()->setAmbient(osg::Vec4(0.3f, 0.3f, 0.35f, 1.0f));
        const double distance = 0.5 * 2 * height * 15.0 / (pixels * std::tan(osg::DegreesToRadians(20.0)));
        double sum = 0.0, count = 0.0;
        for (const double azimuth : {0.3, 2.4, 4.5}) {
            const Picture picture = pictureFrom(
                {distance * std::cos(azimuth), distance * std::sin(azimuth), 7.5}, {0, 0, 7.5}, 0.0);
            for (std::size_t i = 0; i < picture.size(); i += 4)
                if (picture[i] || picture[i + 1] || picture[i + 2]) {
                    sum += luminance({picture[i], picture[i + 1], picture[i + 2]});
                    ++count;
                }
        }
        return sum / count;
    };
    for (const char* name : {"oak", "Norway spruce", "Norway maple", "Douglas fir"})
        for (const double pixels : {600.0, 400.0, 300.0, 150.0, 70.0}) {
            const Species species = *findSpecies(name);
            EXPECT_NEAR(brightness(species, pixels, true), brightness(species, pixels, false), 3.0)
                << name << ' ' << pixels;
        }
}

TEST_F(TreeTiersGlTest, DefineColoursTheTiers) {
    show(wood(40, true));
    for (int i = 0; i < 3; ++i) // near trees get their full motion in the next frame
        pictureFrom({0, -25, 3}, {0, 140, 8}, 0.0);
    const Picture usual = pictureFrom({0, -25, 3}, {0, 140, 8}, 0.0);
    _forest->getOrCreateStateSet()->setDefine("TIERS_COLORED");
    const Picture colored = pictureFrom({0, -25, 3}, {0, 140, 8}, 0.0);
    std::size_t red = 0, yellow = 0, blue = 0;
    for (std::size_t i = 0; i < colored.size(); i += 4) {
        const int r = colored[i], g = colored[i + 1], b = colored[i + 2];
        red += r > g + 40 && r > b + 40;
        yellow += g > b + 40 && g > r - 60;
        blue += b > r + 40 && b > g + 40;
    }
    const auto listed = instancedTrees(*_forest->getInstanced()).treesByTier();
    EXPECT_EQ(listed.front() > 0, red > 100) << red;
    EXPECT_GT(yellow, 100u);
    EXPECT_GT(blue, 100u);
    EXPECT_NEAR(coveredPixels(colored) / coveredPixels(usual), 1.0, 0.05) << "a tier is black";
    _forest->getStateSet()->removeDefine("TIERS_COLORED");
    EXPECT_EQ(pictureFrom({0, -25, 3}, {0, 140, 8}, 0.0), usual);
}

TEST_F(TreeTiersGlTest, NothingPopsDuringAFlight) {
    const int frames = std::getenv("OSGTREEWIND_FLIGHT") ? std::atoi(std::getenv("OSGTREEWIND_FLIGHT"))
                                                         : 30; // set the variable for a longer flight
    std::vector<double> jumps[2];
    for (const bool tiers : {true, false}) {
        show(wood(18, tiers));
        std::vector<double> before;
        for (int i = -5; i < frames; ++i) {
            const double t = std::max(i, 0) / double(frames);
            const osg::Vec3d eye(30.0 * std::sin(3.0 * t), -220.0 + 200.0 * t, 4.0 + 30.0 * t * t);
            const std::vector<double> now = blockMeans(pictureFrom(eye, {0, 120, 8}, (i + 5) / 60.0));
            if (i > 0)
                jumps[tiers].push_back(meanDifference(now, before));
            before = now;
        }
    }
    double most = 0.0;
    for (std::size_t i = 0; i < jumps[0].size(); ++i)
        most = std::max(most, jumps[1][i] - jumps[0][i]);
    EXPECT_LT(most, 1.0);
}

TEST_F(TreeTiersGlTest, CrownKeepsItsDensityDuringATransition) {
    ForestDescription forest = wood(1, true);
    const double pixels = 13.0 * height / (2.0 * 40.0 * std::tan(osg::DegreesToRadians(20.0)));
    forest.drawing.blend = 0.5f;
    forest.drawing.reduced = 0.02f * static_cast<float>(pixels);
    forest.drawing.impostor = 0.0f;
    double covered[3];
    for (const int step : {0, 1, 2}) { // before, during and after the transition from sprays to boughs
        forest.drawing.full = static_cast<float>(pixels) / std::array{1.1f, 0.75f, 0.4f}[step];
        show(forest);
        for (int i = 0; i < 3; ++i)
            covered[step] = coveredPixels(pictureFrom({-17.0, -36.0, 6.5}, {-14.0, 4.0, 6.5}, 0.0));
        const auto listed = instancedTrees(*_forest->getInstanced()).treesByTier();
        EXPECT_EQ(listed[static_cast<std::size_t>(Tier::Sprays)], step < 2) << step;
        EXPECT_EQ(listed[static_cast<std::size_t>(Tier::Boughs)], step > 0) << step;
    }
    EXPECT_NEAR(covered[1] / std::sqrt(covered[0] * covered[2]), 1.0, 0.03);
}

TEST_F(TreeTiersGlTest, TreeBehindOthersHasLessDetail) {
    ForestDescription forest = wood(0, true);
    forest.drawing.full = 300.0f;
    forest.drawing.reduced = 100.0f;
    forest.drawing.impostor = 40.0f;
    const auto tierOfLast = [&] {
        const std::vector<std::size_t> before = listed(forest, forest.trees.size() - 1);
        const std::vector<std::size_t> after = listed(forest, forest.trees.size());
        for (std::size_t tier = 0; tier < after.size(); ++tier)
            if (after[tier] > before[tier])
                return static_cast<Tier>(tier);
        return Tier::BareImpostor;
    };
    plantSpruce(forest, 0.0f, 90.0f, 14.0f);
    EXPECT_LT(tierOfLast(), Tier::Impostor);
    forest.trees.clear();
    for (int row = 0; row < 4; ++row)
        for (int i = -4; i <= 4; ++i)
            plantSpruce(forest, 2.0f * static_cast<float>(i), 15.0f + 15.0f * static_cast<float>(row), 6.0f);
    plantSpruce(forest, 0.0f, 90.0f, 14.0f);
    EXPECT_EQ(tierOfLast(), Tier::Impostor) << "behind four rows";
    forest.trees.back().size.height = 40.0f;
    EXPECT_LT(tierOfLast(), Tier::Impostor) << "it is taller than the rows in front of it";
}

TEST_F(TreeTiersGlTest, HiddenTreeIsNotDrawn) {
    ForestDescription forest = wood(0, true);
    const auto count = [&](std::size_t trees) {
        const std::vector<std::size_t> drawn = listed(forest, trees);
        return std::accumulate(drawn.begin(), drawn.end(), std::size_t{0});
    };
    forest.drawing.blend = 0.0f; // each tree counts once
    for (int row = 0; row < 12; ++row)
        for (int i = -8; i <= 8; ++i)
            plantSpruce(forest, 2.0f * static_cast<float>(i), 14.0f + 5.0f * static_cast<float>(row), 14.0f);
    const std::size_t before = forest.trees.size();
    for (int i = 0; i < 50; ++i)
        plantSpruce(forest, 0.1f * static_cast<float>(i), 150.0f + 4.0f * static_cast<float>(i), 12.0f);
    const std::size_t behind = forest.trees.size();
    const std::size_t drawn = count(before);
    const Picture without = pictureFrom({0, 0, 1.7}, {0, 20, 3}, 0.0);
    const std::size_t drawnOfAll = count(behind);
    EXPECT_LE(drawnOfAll, drawn + 5) << "the others hide most of fifty trees";
    const Picture with = pictureFrom({0, 0, 1.7}, {0, 20, 3}, 0.0);
    std::size_t different = 0;
    for (std::size_t i = 0; i < with.size(); i += 4)
        different += !std::equal(&with[i], &with[i] + 4, &without[i]);
    EXPECT_LT(different, 10u) << "more trees change the wind a little";
    plantSpruce(forest, 0.0f, 4.0f, 0.5f);
    EXPECT_EQ(count(behind + 1), drawnOfAll + 1) << "a small tree in front of the others";
    _forest->getInstanced()->setLeafState(1, new osg::StateSet); // may make more of a tree visible
    pictureFrom({0, 0, 1.7}, {0, 20, 3}, 0.0);
    const auto ofHost = instancedTrees(*_forest->getInstanced()).treesByTier();
    EXPECT_GE(std::accumulate(ofHost.begin(), ofHost.end(), std::size_t{0}), drawn + 51)
        << "trees with state of a host hide nothing and are not hidden";
}

TEST_F(TreeTiersGlTest, DetailFollowsTheBudgetOfTheView) {
    struct Case {
        float budget;
        double detail;
    };
    std::vector<std::size_t> full, least;
    for (const Case& each : {Case{10000.0f, 1.0}, Case{1e-3f, DetailBudget::minDetail}}) {
        ForestDescription description = wood(12, true);
        description.drawing.budget = each.budget;
        show(description);
        for (int i = 0; i < 40; ++i)
            pictureFrom({0, -20, 3}, {0, 140, 8}, i / 30.0);
        double detail = 0.0;
        const unsigned frame = viewer().getFrameStamp()->getFrameNumber();
        ASSERT_TRUE(viewer().getCamera()->getStats()->getAttribute(frame, "Tree detail", detail));
        EXPECT_EQ(detail, each.detail) << each.budget << " ms";
        const auto listed = instancedTrees(*_forest->getInstanced()).treesByTier();
        (each.detail == 1.0 ? full : least).assign(listed.begin(), listed.end());
    }
    ForestDescription without = wood(12, true);
    show(without);
    pictureFrom({0, -20, 3}, {0, 140, 8}, 0.0);
    const auto listed = instancedTrees(*_forest->getInstanced()).treesByTier();
    EXPECT_EQ(full, std::vector<std::size_t>(listed.begin(), listed.end()));
    double detail = 0.0;
    EXPECT_FALSE(viewer().getCamera()->getStats()->getAttribute(1, "Tree detail", detail))
        << "without a budget";
    EXPECT_GT(least[static_cast<std::size_t>(Tier::Impostor)],
              full[static_cast<std::size_t>(Tier::Impostor)]);
    EXPECT_EQ(least[static_cast<std::size_t>(Tier::Full)], 0u);
}
