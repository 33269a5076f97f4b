// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/UnitPose.h>

#include <tests/Near.h>

#include <osgTreeWind/base/Random.h>

#include <gtest/gtest.h>

using namespace osgTreeWind;

namespace {

constexpr float tolerance = 1e-4f;

/// Fig 3.10: unit 0 carries two chains, 1-2 and 3-4.
Skeleton twoChains() {
    Skeleton skeleton;
    skeleton.units.resize(5);
    const int parents[] = {-1, 0, 1, 0, 3};
    const glm::vec3 tips[] = {{0, 0, 2}, {1, 0, 3}, {2, 0.5f, 3.5f}, {-1, 0.2f, 3}, {-2, 0, 3.3f}};
    for (int i = 0; i < 5; ++i) {
        BranchUnit& unit = skeleton.units[static_cast<std::size_t>(i)];
        unit.parent = parents[i];
        unit.base = parents[i] < 0 ? glm::vec3(0.0f) : tips[parents[i]];
        unit.tip = tips[i];
    }
    return skeleton;
}

glm::quat randomTurn(Random& random) {
    const glm::vec3 axis(random.symmetric(), random.symmetric(), random.symmetric() + 2.0f);
    return glm::angleAxis(random.symmetric() * 1.5707963f, glm::normalize(axis));
}

std::vector<UnitPose> pose(const Skeleton& skeleton, const TreeScale& scale,
                           const std::vector<glm::quat>& rotations) {
    std::vector<UnitPose> poses(skeleton.units.size());
    composePoses(skeleton, scale, rotations.data(), poses.data());
    return poses;
}

} // namespace

TEST(UnitPose, NoRotationIsTheRestPose) {
    const Skeleton skeleton = twoChains();
    for (const UnitPose& p : pose(skeleton, {}, std::vector<glm::quat>(5, glm::quat(1, 0, 0, 0))))
        expectNear(p.apply({1, 2, 3}), {1, 2, 3}, tolerance);
}

TEST(UnitPose, QuarterTurnsAddUpDownTheChain) {
    // Two links of 1 m standing on each other, each turned 90 degrees about Y: the second points down.
    Skeleton skeleton;
    skeleton.units.resize(2);
    skeleton.units[0].tip = {0, 0, 1};
    skeleton.units[1] = {0, 1, {0, 0, 1}, {0, 0, 2}, 0, 0};
    const glm::quat quarter = glm::angleAxis(1.5707963f, glm::vec3(0, 1, 0));
    const auto poses = pose(skeleton, {}, {quarter, quarter});
    expectNear(poses[0].apply({0, 0, 1}), {1, 0, 0}, tolerance);
    expectNear(poses[1].apply({0, 0, 2}), {1, 0, -1}, tolerance);
}

TEST(UnitPose, JointsStayConnectedUnderAnyAngles) {
    const Skeleton skeleton = twoChains();
    Random random(7);
    for (int trial = 0; trial < 200; ++trial) {
        TreeScale scale;
        scale.axes = {0.3f + random.uniform(), 0.3f + random.uniform(), 0.5f + 4.0f * random.uniform()};
        std::vector<glm::quat> rotations;
        for (int i = 0; i < 5; ++i)
            rotations.push_back(randomTurn(random));
        const auto poses = pose(skeleton, scale, rotations);
        expectNear(poses[0].apply({0, 0, 0}), {0, 0, 0}, tolerance);
        for (std::size_t i = 1; i < 5; ++i) {
            const BranchUnit& unit = skeleton.units[i];
            const glm::vec3 joint = scale.axes * unit.base;
            expectNear(poses[static_cast<std::size_t>(unit.parent)].apply(joint), poses[i].apply(joint),
                       tolerance);
        }
    }
}

TEST(UnitPose, BranchesKeepTheirLength) {
    const Skeleton skeleton = twoChains();
    Random random(8);
    std::vector<glm::quat> rotations;
    for (int i = 0; i < 5; ++i)
        rotations.push_back(randomTurn(random));
    const auto poses = pose(skeleton, {}, rotations);
    for (std::size_t i = 0; i < 5; ++i) {
        const BranchUnit& unit = skeleton.units[i];
        EXPECT_NEAR(glm::length(poses[i].apply(unit.tip) - poses[i].apply(unit.base)),
                    glm::length(unit.tip - unit.base), tolerance);
    }
}

TEST(UnitPose, SiblingsDoNotAffectEachOther) {
    const Skeleton skeleton = twoChains();
    std::vector<glm::quat> rotations(5, glm::angleAxis(0.2f, glm::vec3(1, 0, 0)));
    const auto before = pose(skeleton, {}, rotations);
    rotations[1] = glm::angleAxis(1.1f, glm::vec3(0, 1, 0));
    const auto after = pose(skeleton, {}, rotations);
    for (const std::size_t other : {0u, 3u, 4u})
        EXPECT_EQ(before[other].apply(skeleton.units[other].tip),
                  after[other].apply(skeleton.units[other].tip));
    EXPECT_GT(glm::length(before[2].apply({2, 0.5f, 3.5f}) - after[2].apply({2, 0.5f, 3.5f})), 0.5f);
}
