// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/CrownShade.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr float density = 0.4f;                ///< Leaf area density of the box, m^2/m^3.
const glm::vec3 low(-2, -3, 0), high(2, 3, 8); ///< Corners of the box.

std::array<LeafVertex, verticesPerLeafCluster> mesh() {
    return makeLeafMesh(LeafParameters());
}

/// A box filled uniformly with small clusters.
CrownShade box() {
    std::vector<LeafCluster> leaves;
    const int steps = 32; // two per grid cell
    float area = 0.0f;
    for (std::size_t i = 0; i < mesh().size(); i += 4)
        area += glm::length(
            glm::cross(mesh()[i + 1].corner - mesh()[i].corner, mesh()[i + 3].corner - mesh()[i].corner));
    const float size = 1e-3f;
    for (int i = 0; i < (steps + 1) * (steps + 1) * (steps + 1); ++i) {
        const glm::vec3 at(i % (steps + 1), i / (steps + 1) % (steps + 1), i / ((steps + 1) * (steps + 1)));
        LeafCluster leaf;
        leaf.anchor = low + (high - low) * at / static_cast<float>(steps);
        leaf.size = size;
        for (int axis = 0; axis < 3; ++axis) // half of its surroundings are outside
            if (at[axis] == 0.0f || at[axis] == static_cast<float>(steps))
                leaf.size *= std::sqrt(0.5f);
        leaves.push_back(leaf);
    }
    const glm::vec3 step = (high - low) / static_cast<float>(steps);
    return CrownShade(leaves, mesh(), density * step.x * step.y * step.z / (area * size * size));
}

double left(double path) {
    return std::exp(-static_cast<double>(CrownShade::projection * CrownShade::clumping) *
                    std::sqrt(1.0 - static_cast<double>(CrownShade::scattering)) * density * path);
}

} // namespace

TEST(CrownShade, TransmissionOfAUniformBoxFollowsThePathLength) {
    const CrownShade shade = box();
    for (const glm::vec3& p : {glm::vec3(0, 0, 4), glm::vec3(1, -2, 6.5), glm::vec3(-1.5, 2.5, 1)}) {
        const CrownShade::Light light = shade.at(p);
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_NEAR(light.above[axis], left(static_cast<double>(high[axis] - p[axis])), 0.005) << axis;
            EXPECT_NEAR(light.below[axis], left(static_cast<double>(p[axis] - low[axis])), 0.005) << axis;
        }
    }
}

TEST(CrownShade, DiagonalsOfAUniformBoxAreAsLongAsTheyAre) { // sky: 14 directions, up 2, level 1, down 0
    const CrownShade::Light light = box().at({0, 0, 4});
    const double diagonal = left(0.5 * static_cast<double>(glm::length(high - low)));
    const double axis = 1.0 / 15.0, corner = 3.0 / 40.0;
    const double level = 2.0 * axis * (left(2.0) + left(3.0)), upright = 2.0 * axis * left(4.0);
    const double expected = level + upright + corner * 8.0 * diagonal;
    EXPECT_NEAR(static_cast<double>(light.sky), expected, 0.005);
    EXPECT_NEAR(static_cast<double>(light.ground), expected, 0.005);
}

TEST(CrownShade, APlaceOutsideIsShadedFromTheSideOfTheCrownOnly) {
    const CrownShade::Light light = box().at({0, 0, 9});
    EXPECT_NEAR(light.above.z, 1.0f, 1e-3f);
    EXPECT_NEAR(light.below.z, left(8.0), 0.005);
}

TEST(CrownShade, WithoutLeavesThereIsNoShade) {
    for (const CrownShade& shade : {CrownShade(), CrownShade({}, mesh(), 0.4f)}) {
        const CrownShade::Light light = shade.at({1, 2, 3});
        EXPECT_EQ(light.above, glm::vec3(1));
        EXPECT_EQ(light.below, glm::vec3(1));
        EXPECT_EQ(light.sky, 1.0f);
        EXPECT_EQ(light.ground, 1.0f);
    }
}

TEST(CrownShade, LeafAreaIndexIsLimited) {
    LeafCluster leaf;
    leaf.anchor = {0, 0, 3};
    std::vector<LeafCluster> leaves(1000, leaf);
    for (std::size_t i = 0; i < leaves.size(); ++i)
        leaves[i].anchor += glm::vec3(i % 10, i / 10 % 10, i / 100) * 0.3f;
    const CrownShade::Light some = CrownShade(leaves, mesh(), 0.5f).at({1, 1, 3}),
                            more = CrownShade(leaves, mesh(), 1.0f).at({1, 1, 3});
    EXPECT_EQ(some.above, more.above);
    EXPECT_GT(some.above.z, 0.02f);
}

TEST(CrownShade, OutwardPointsAwayFromTheCentreOfTheAnchors) {
    const CrownShade shade = box();
    EXPECT_GT(shade.outward({1.5, 0, 4}).x, 0.99f);
    EXPECT_LT(shade.outward({0, -2, 4}).y, -0.99f);
    EXPECT_GT(shade.outward({0, 0, 7}).z, 0.99f);
    EXPECT_EQ(CrownShade().outward({0, 0, 0}), glm::vec3(0, 0, 1));
}
