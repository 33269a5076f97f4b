// SPDX-License-Identifier: MIT
#include <tests/tool/portraits/LeafEdges.h>

#include <tests/tool/portraits/SolidMask.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>

#include <gtest/gtest.h>

#include <utility>

using namespace osgTreeWind;

namespace {

constexpr int size = 256, closing = 8;
/// Bars as wide as the gaps between them, over half of the picture.
Silhouette bars(int width) {
    Silhouette picture(size);
    for (int x = 64; x < 192; x += 2 * width)
        picture.draw({x, 64}, {width, 0}, {0, 128}, solidMask);
    return picture;
}

} // namespace

TEST(LeafEdges, CountChangesAndRunsAlongLines) {
    for (const int width : {1, 2, 4}) {
        const LeafEdges edges = measureEdges(bars(width), closing);
        EXPECT_NEAR(edges.edges, 1.0f / static_cast<float>(width), 0.06f) << width;
        EXPECT_NEAR(edges.leafRun, static_cast<float>(width), 0.01f) << width;
        EXPECT_NEAR(edges.skyRun, static_cast<float>(width), 0.2f) << width;
    }
}

TEST(LeafEdges, ASolidSquareHasNone) {
    Silhouette square(size);
    square.draw({64, 64}, {128, 0}, {0, 128}, solidMask);
    const LeafEdges edges = measureEdges(square, closing);
    EXPECT_EQ(edges.edges, 0.0f);
    EXPECT_EQ(edges.leafRun, 128.0f);
    EXPECT_EQ(measureEdges(Silhouette(size), closing).edges, 0.0f);
}

/// The aim is a ratio of 0.85 to 1.25.
TEST(LeafEdges, OfCrownsAreAsFineAsThoseOfSingleLeaves) {
    for (const char* name : {"oak", "beech", "silver birch", "sycamore", "Norway spruce", "Scots pine"}) {
        const Species species = *findSpecies(name);
        const TreeModel model = makeTreeModel(species.tree);
        for (const auto& [reductions, distance] : {std::pair(0, 20.0f), {2, 40.0f}, {3, 40.0f}, {5, 80.0f}}) {
            const EdgePicture picture(model, species.appearance, distance, 0.3f);
            const LeafEdges single = picture.singleLeaves(), drawn = picture.cards(reductions);
            // Needles are round, so their cards are larger.
            const float least = species.appearance.hasNeedles() ? 0.7f : 0.82f;
            EXPECT_GT(drawn.edges / single.edges, least) << name << ", " << reductions;
            EXPECT_LT(drawn.edges / single.edges, 1.27f) << name << ", " << reductions;
            EXPECT_LT(drawn.leafRun / single.leafRun, species.appearance.hasNeedles() ? 1.5f : 1.4f)
                << name << ", " << reductions;
            EXPECT_GT(drawn.skyRun / single.skyRun, 0.6f) << name << ", " << reductions;
        }
    }
}

TEST(LeafEdges, AreThoseOfTheTierAtADistance) {
    const Species& oak = *findSpecies("oak");
    const TreeModel model = makeTreeModel(oak.tree);
    const auto ratio = [&](int reductions, float distance) {
        const EdgePicture picture(model, oak.appearance, distance, 0.3f);
        return picture.cards(reductions).edges / picture.singleLeaves().edges;
    };
    EXPECT_EQ(edgesOverSingleLeaves(model, oak.appearance, 10.0f), ratio(0, 10.0f));
    EXPECT_NE(edgesOverSingleLeaves(model, oak.appearance, 80.0f), ratio(0, 80.0f));
    for (const float distance : {10.0f, 20.0f, 40.0f, 80.0f})
        EXPECT_GT(edgesOverSingleLeaves(model, oak.appearance, distance), 0.7f) << distance;
}
