// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/damage/FallingTree.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

GrownTree spruce(float leaves = 1.0f) {
    TreeSize size;
    size.height = 20.0f;
    size.trunkDiameter = 0.24f;
    return {"Norway spruce", size, leaves};
}

GrownTree withoutDrag() {
    TreeSize size;
    size.height = 20.0f;
    Species species = *findSpecies("Norway spruce");
    species.wood.woodDrag = species.wood.crownDrag = 0.0f;
    return {species, size, 0.0f};
}

} // namespace

// Conservation of energy: w^2 = 2 c (cos lean - cos(lean + angle)), with c = 3 g / (2 L) for a rod.
TEST(FallingTree, FallsLikeARigidBodyWithoutDrag) {
    const GrownTree tree = withoutDrag();
    FallingTree falling(tree.form(), 0, 0.0, 0.1);
    double first = 0.0;
    for (int i = 1; i < 2000 && falling.angle() < 1.2; ++i) {
        falling.step(0.01);
        const double c =
            falling.speed() * falling.speed() / (2.0 * (std::cos(0.1) - std::cos(0.1 + falling.angle())));
        if (falling.angle() < 0.2)
            first = c;
        else
            EXPECT_NEAR(c / first, 1.0, 0.02) << falling.angle();
    }
    EXPECT_GT(falling.angle(), 1.2);
    EXPECT_GT(first / (1.5 * 9.81 / 20.0), 0.9); // a tapered trunk is lighter at its top than a rod
    EXPECT_LT(first / (1.5 * 9.81 / 20.0), 2.0); // and falls faster
}

TEST(FallingTree, ComesToRestOnItsCrownAfterSeconds) {
    const GrownTree tree = spruce();
    FallingTree falling(tree.form(), 0, 50000.0, 0.1);
    double time = 0.0;
    for (; time < 60.0 && !falling.isAtRest(); time += 0.1)
        falling.step(0.1);
    EXPECT_GT(time, 1.5);
    EXPECT_LT(time, 12.0);
    EXPECT_LT(falling.restAngle(), 1.5707964);
    EXPECT_GT(falling.restAngle(), 1.2);
    falling.step(1.0);
    EXPECT_EQ(falling.angle(), falling.restAngle());
    EXPECT_EQ(falling.speed(), 0.0);
}

TEST(FallingTree, AirSlowsATreeInLeaf) {
    const GrownTree leafy = spruce(), bare = spruce(0.0f);
    FallingTree slow(leafy.form(), 0, 0.0, 0.2), fast(bare.form(), 0, 0.0, 0.2);
    double slowest = 0.0, fastest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        slow.step(0.01);
        fast.step(0.01);
        slowest = std::max(slowest, slow.speed());
        fastest = std::max(fastest, fast.speed());
    }
    EXPECT_TRUE(slow.isAtRest() && fast.isAtRest());
    EXPECT_LT(slowest, 0.98 * fastest);
}

TEST(FallingTree, DoesNotDependOnTheStep) {
    const GrownTree tree = spruce();
    FallingTree coarse(tree.form(), 0, 50000.0, 0.1), fine(tree.form(), 0, 50000.0, 0.1);
    coarse.step(1.0);
    for (int i = 0; i < 1000; ++i)
        fine.step(0.001);
    EXPECT_GT(fine.angle(), 0.05);
    EXPECT_NEAR(coarse.angle() / fine.angle(), 1.0, 0.02);
}

TEST(FallingTree, ASnappedTreeComesToRestBelowItsStump) {
    const GrownTree tree = spruce();
    unsigned above = 0;
    while (tree.units()[above].level != 0 || tree.units()[above].base.z <= 0.0f)
        ++above;
    const double stump = static_cast<double>(tree.scale.axes.z * tree.units()[above].base.z);
    const FallingTree whole(tree.form(), 0, 0.0, 0.1), snapped(tree.form(), above, 0.0, 0.1);
    EXPECT_NEAR(snapped.restAngle() - whole.restAngle(), std::asin(stump / (20.0 - stump)), 0.03);
}

TEST(FallingTree, ABoughEndsUpHanging) {
    TreeSize size;
    size.height = 15.0f;
    const GrownTree oak("oak", size);
    unsigned bough = 0;
    while (oak.units()[bough].level != 1)
        ++bough;
    FallingTree falling(oak.form(), bough, 0.0, 0.0);
    for (int i = 0; i < 200; ++i)
        falling.step(0.1);
    EXPECT_TRUE(falling.isAtRest());
    const glm::vec2 axis = falling.axis();
    const glm::quat turn = glm::angleAxis(static_cast<float>(falling.angle()), glm::vec3(axis, 0.0f));
    glm::vec3 way = oak.units()[bough].tip - oak.units()[bough].base;
    EXPECT_LT((turn * glm::normalize(way)).z, -0.5f);
}
