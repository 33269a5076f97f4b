// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafSpray.h>
#include <tests/NamesInOrder.h>

#include <osgTreeWind/drawing/looks/BoughCard.h>
#include <osgTreeWind/drawing/looks/LeafAtlas.h>
#include <osgTreeWind/drawing/looks/LeafStencils.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int twigs = 2, all = 3;

/// Share of a card that leaves cover, without leaves in front of twigs.
float leavesOn(const LeafTexels& card) {
    float sum = 0.0f;
    for (const glm::vec4& texel : card.texels)
        sum += texel.a - texel.b;
    return sum / static_cast<float>(card.texels.size());
}

float twigsOn(const LeafTexels& card) {
    float sum = 0.0f;
    for (const glm::vec4& texel : card.texels)
        sum += texel.b;
    return sum / static_cast<float>(card.texels.size());
}

LeafTexels painted(LeafForm form, int variant) {
    return paintSpray(form, growSpray(form, variant));
}

} // namespace

class LeafSprayFormTest : public testing::TestWithParam<int> {
protected:
    LeafForm form() const { return static_cast<LeafForm>(GetParam()); }
};

TEST_P(LeafSprayFormTest, HasTheCoverageOfTheMechanics) {
    float leaves = 0.0f, bare = 0.0f;
    for (int variant = 0; variant < LeafAtlas::sprays; ++variant) {
        leaves += leavesOn(painted(form(), variant)) / LeafAtlas::sprays;
        bare += twigsOn(painted(form(), variant)) / LeafAtlas::sprays;
    }
    EXPECT_NEAR(bare, twigCoverage(form()), 0.01f);
    EXPECT_NEAR(leaves, leafCoverage(form()), 0.035f) << "half of a large leaf";
}

TEST_P(LeafSprayFormTest, GrowsFromTheLowerEdge) {
    const LeafTexels spray = painted(form(), 0);
    float foot = 0.0f, elsewhere = 0.0f;
    for (int x = 0; x < spray.size; ++x)
        (std::abs(x - spray.size / 2) < spray.size / 16 ? foot : elsewhere) += spray.at(x, 1).b;
    EXPECT_GT(foot, 0.5f);
    if (form() == LeafForm::Frond) {
        EXPECT_GT(elsewhere, 0.75f * static_cast<float>(spray.size)); // its rib
    } else {
        EXPECT_EQ(elsewhere, 0.0f);
    }
}

TEST_P(LeafSprayFormTest, HidesTheEdgesOfTheCard) {
    if (form() == LeafForm::Frond)
        return; // extends into its neighbours
    const LeafTexels spray = painted(form(), 0);
    const int last = spray.size - 1;
    float edge = 0.0f;
    for (int i = 0; i <= last; ++i) {
        edge += spray.at(0, i).a + spray.at(last, i).a + spray.at(i, last).a;
        if (i < spray.size / 8 || i > last - spray.size / 8) {
            EXPECT_EQ(spray.at(i, 0).a, 0.0f) << i;
        }
    }
    EXPECT_LT(edge / (3.0f * static_cast<float>(spray.size)), 0.05f);
}

TEST_P(LeafSprayFormTest, VariantsDiffer) {
    const LeafTexels one = painted(form(), 0), other = painted(form(), 1);
    double apart = 0.0;
    for (std::size_t i = 0; i < one.texels.size(); ++i)
        apart += static_cast<double>(std::abs(one.texels[i].a - other.texels[i].a));
    EXPECT_GT(apart / static_cast<double>(one.texels.size()), 0.15);
}

TEST_P(LeafSprayFormTest, MipmapLevelsHaveEqualCoverage) {
    const std::vector<LeafTexels> levels = leafMipmaps(painted(form(), 0));
    ASSERT_EQ(levels.size(), 10u);
    const auto mean = [](const LeafTexels& level, int channel) {
        float sum = 0.0f;
        for (const glm::vec4& texel : level.texels)
            sum += texel[channel] / static_cast<float>(level.texels.size());
        return sum;
    };
    for (const LeafTexels& level : levels)
        for (const int channel : {twigs, all})
            EXPECT_NEAR(mean(level, channel), mean(levels.front(), channel), 1e-3f) << level.size;
}

TEST_P(LeafSprayFormTest, DistantStencilsHaveEqualCoverage) {
    const LeafTexels card = painted(form(), 0);
    const osg::ref_ptr<osg::Image> atlas = makeLeafAtlas({card, card, card}, {card});
    const LeafStencils stencils(*atlas, LeafAtlas::spray(0));
    const float wanted = leafMipmaps(card).back().texels.front().a;
    for (const std::size_t level : {2u, 4u, 6u, 8u}) {
        float solid = 0.0f;
        for (const std::uint8_t cell : stencils.level(level).leaves)
            solid += static_cast<float>(cell) / static_cast<float>(stencils.level(level).leaves.size());
        EXPECT_NEAR(solid, wanted, 0.05f) << level;
    }
}

TEST_P(LeafSprayFormTest, BoughsHaveTheCoverageOfASpray) {
    const LeafTexels full = painted(form(), 0);
    const std::vector<LeafTexels> sparse{paintSpray(form(), growSpray(form(), 0, 0.6f))};
    for (const int enlargement : {2, 3, 4}) {
        const LeafTexels bough = paintBough(sparse, full, enlargement, 0);
        EXPECT_EQ(bough.size, full.size / 2);
        float wanted = 0.0f, there = 0.0f;
        for (const glm::vec4& texel : full.texels)
            wanted += texel.a / static_cast<float>(full.texels.size());
        for (const glm::vec4& texel : bough.texels)
            there += texel.a / static_cast<float>(bough.texels.size());
        EXPECT_NEAR(there, wanted, 0.04f) << enlargement;
    }
}

INSTANTIATE_TEST_SUITE_P(Forms, LeafSprayFormTest, testing::Range(0, leafFormCount),
                         NamesInOrder({"Blade", "Lobed", "Ovate", "Rhombic", "Palmate", "Pinnate", "Heart",
                                       "Round", "Fingered", "Fan", "Needles", "Bundles", "Tufts", "Frond",
                                       "Pointed", "Combed"}));

TEST(LeafSpray, EveryFormLooksDifferent) {
    for (int a = 0; a < leafFormCount; ++a)
        for (int b = 0; b < a; ++b) {
            const LeafTexels one = painted(static_cast<LeafForm>(a), 0),
                             other = painted(static_cast<LeafForm>(b), 0);
            double apart = 0.0;
            for (std::size_t i = 0; i < one.texels.size(); ++i)
                apart += static_cast<double>(std::abs(one.texels[i].a - other.texels[i].a));
            EXPECT_GT(apart / static_cast<double>(one.texels.size()), 0.15) << a << ", " << b;
        }
}

TEST(LeafAtlas, CardsDoNotOverlap) {
    const LeafAtlas::Cell cells[] = {LeafAtlas::spray(0),    LeafAtlas::spray(1),    LeafAtlas::spray(2),
                                     LeafAtlas::bough(2, 0), LeafAtlas::bough(2, 1), LeafAtlas::bough(3),
                                     LeafAtlas::bough(4)};
    float area = 0.0f;
    for (const LeafAtlas::Cell& a : cells) {
        area += a.size * a.size;
        for (const LeafAtlas::Cell& b : cells)
            EXPECT_TRUE(&a == &b || a.low.x + a.size <= b.low.x || b.low.x + b.size <= a.low.x ||
                        a.low.y + a.size <= b.low.y || b.low.y + b.size <= a.low.y);
    }
    EXPECT_FLOAT_EQ(area, 1.0f);
}

TEST(LeafAtlas, NeighboursDiffer) {
    for (std::size_t cluster = 0; cluster < 100; ++cluster)
        for (std::size_t quad = 0; quad < 2; ++quad)
            EXPECT_NE(LeafAtlas::choose(cluster, quad).variant, LeafAtlas::choose(cluster, quad + 1).variant);
    std::array<int, 6> used{};
    for (std::size_t cluster = 0; cluster < 600; ++cluster) {
        const LeafAtlas::Choice choice = LeafAtlas::choose(cluster, 0);
        ++used[static_cast<std::size_t>(2 * choice.variant + choice.mirrored)];
    }
    for (const int times : used)
        EXPECT_NEAR(times, 100, 20);
}
