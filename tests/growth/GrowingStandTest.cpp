// SPDX-License-Identifier: MIT
#include <tests/growth/HabitCases.h>

#include <osgTreeWind/growth/GrowTree.h>
#include <osgTreeWind/growth/GrowthKeys.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace osgTreeWind {
namespace {

constexpr int rows = 11;
constexpr float spacing = 2.0f;
constexpr std::size_t middle = rows * rows / 2;
constexpr std::size_t atEdge = rows / 2; ///< Middle of the row with the lowest y.

GrowingStand spruces(int years) {
    GrowingStand stand(lightCellSize(spruceHabit()));
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < rows; ++x)
            stand.add(GrowingTree(spruceHabit(), {20.0f, 0.3f, 6.0f},
                                  {spacing * static_cast<float>(x), spacing * static_cast<float>(y), 0.0f},
                                  static_cast<std::uint32_t>(rows * y + x)));
    for (int year = 0; year < years; ++year)
        stand.growYear();
    return stand;
}

/// Grown once, shared by the tests that do not change it.
const GrowingStand& grownSpruces() {
    static const GrowingStand stand = spruces(32);
    return stand;
}

/// Leaf area between two relative heights, m². @param side sign of y; 0 for all sides.
float leaves(const GrowingTree& tree, float from, float to, float side = 0.0f) {
    float area = 0.0f;
    for (const Metamer& metamer : tree.state().metamers) {
        const float z = metamer.position.z / tree.height();
        if (z >= from && z < to && (side == 0.0f || side * metamer.position.y > 0.3f))
            area += metamer.leafArea;
    }
    return area;
}

TEST(GrowingStand, DenseSprucesAreDeadBelowHalfTheirHeight) {
    const GrowingTree& tree = grownSpruces().trees()[middle];
    EXPECT_GT(tree.height(), 10.0f);
    EXPECT_LT(leaves(tree, 0.0f, 0.5f), 0.03f * leaves(tree, 0.0f, 1.1f));
    int dead = 0;
    for (const Metamer& metamer : tree.state().metamers)
        dead += metamer.died >= 0 && metamer.position.z < 0.5f * tree.height();
    EXPECT_GT(dead, 20) << "dead boughs do not fall at once";
}

TEST(GrowingStand, EdgeTreesAreGreenToTheGroundOnTheirOpenSide) {
    const GrowingTree& tree = grownSpruces().trees()[atEdge];
    EXPECT_GT(leaves(tree, 0.0f, 0.25f, -1.0f), 4.0f * leaves(tree, 0.0f, 0.25f, 1.0f));
    EXPECT_GT(leaves(tree, 0.0f, 0.25f, -1.0f), 0.05f * leaves(tree, 0.0f, 1.1f, -1.0f));
}

TEST(GrowingStand, LivingBoughsHaveEnoughLightForTheirWood) {
    for (const GrowingTree& tree : grownSpruces().trees()) {
        const std::vector<Metamer>& metamers = tree.state().metamers;
        std::vector<float> fed(metamers.size()), wood(metamers.size());
        for (std::size_t i = metamers.size() - 1; i > 0; --i) {
            const Metamer& metamer = metamers[i];
            const auto parent = static_cast<std::size_t>(metamer.parent);
            fed[i] += metamer.leafArea * metamer.light;
            wood[i] += metamer.died < 0 ? metamer.length : 0.0f;
            fed[parent] += fed[i];
            wood[parent] += wood[i];
            const bool bough = metamer.order == 1 && metamers[parent].order == 0 && metamer.died < 0;
            if (bough && tree.state().year - metamer.born > 6) {
                EXPECT_GT(fed[i], 0.015f * spruceHabit().leafArea * wood[i]) << "of " << wood[i] << " m";
            }
        }
    }
}

TEST(GrowingStand, NeighboursFillAGapWithinTenYears) {
    GrowingStand stand = spruces(26);
    const glm::vec2 gap(stand.trees()[middle].foot());
    stand.remove(middle);
    const auto inGap = [&] {
        float area = 0.0f;
        for (const GrowingTree& tree : stand.trees())
            for (const Metamer& metamer : tree.state().metamers) {
                const glm::vec2 place(tree.foot() + metamer.position);
                if (glm::distance(place, gap) < 0.5f * spacing)
                    area += metamer.leafArea;
            }
        return area;
    };
    const float before = inGap();
    for (int year = 0; year < 10; ++year)
        stand.growYear();
    EXPECT_GT(inGap(), 2.0f * before + 1.0f);
}

TEST(GrowingStand, GrowsTheSameInEveryRun) {
    GrowingStand one = spruces(12), other = spruces(12);
    for (std::size_t i = 0; i < one.trees().size(); ++i) {
        const auto& a = one.trees()[i].state().metamers;
        const auto& b = other.trees()[i].state().metamers;
        ASSERT_EQ(a.size(), b.size());
        ASSERT_TRUE(std::equal(a.begin(), a.end(), b.begin(),
                               [](const Metamer& p, const Metamer& q) { return p.position == q.position; }));
    }
}

TEST(GrowingStand, EmptyStandStaysEmpty) {
    GrowingStand stand(0.4f);
    stand.growYear();
    EXPECT_TRUE(stand.trees().empty());
}

} // namespace
} // namespace osgTreeWind
