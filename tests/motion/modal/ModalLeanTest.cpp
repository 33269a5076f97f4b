// SPDX-License-Identifier: MIT
// The lean against the fully posed tree.
#include <osgTreeWind/motion/modal/ModalLean.h>

#include <osgTreeWind/motion/laws/UnitPose.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

constexpr float heading = 0.7f;

glm::vec2 turned(const glm::vec2& v) {
    return {std::cos(heading) * v.x - std::sin(heading) * v.y,
            std::sin(heading) * v.x + std::cos(heading) * v.y};
}

/// Sums of squares over time of a crown's displacement, fully posed and by its lean.
struct LeanErrors {
    float crown = 0.0f, difference = 0.0f; ///< For the mean over the leaf clusters.
    float relative() const { return std::sqrt(difference / crown); }
};

LeanErrors leanErrors(const GrownTree& tree, const WindField& wind, ModalMotion::Level level) {
    ModalMotion::Tree placed;
    placed.form = tree.form();
    placed.heading = heading;
    placed.level = level;
    ModalMotion motion({placed}, 1.0f, runInTurn);
    motion.sampleWind(&wind, 0.0);
    const std::size_t units = tree.units().size();
    const float height = measureTree(tree.model, tree.scale).height;
    std::vector<glm::vec2> angles(units);
    std::vector<glm::quat> rotations(units);
    std::vector<UnitPose> poses(units);
    LeanErrors errors;
    for (int i = 1; i <= 1500; ++i) {
        motion.step(&wind, i / 60.0, 1.0f / 60.0f);
        if (i < 300 || i % 16 != 0)
            continue;
        motion.angles(0, angles.data());
        for (std::size_t i = 0; i < angles.size(); ++i)
            rotations[i] = swungRotation(tree.model.skeleton.units[i], tree.scale, angles[i]);
        composePoses(tree.model.skeleton, tree.scale, rotations.data(), poses.data());
        glm::vec2 full(0.0f), leaning(0.0f);
        for (const LeafCluster& leaf : tree.model.leaves) {
            const glm::vec3 rest = tree.scale.axes * leaf.anchor;
            full += turned(poses[static_cast<std::size_t>(leaf.unit)].apply(rest) - rest);
            leaning += std::pow(std::max(rest.z / height, 0.0f), leanPower) * motion.lean(0);
        }
        errors.crown += glm::dot(full, full);
        errors.difference += glm::dot(leaning - full, leaning - full);
    }
    return errors;
}

TEST(ModalLean, MatchesTheCrownsOfBuiltInSpecies) {
    for (const Species& species : SpeciesCatalogue::current().species())
        for (const TreeSize& size : {TreeSize{18, 0.3f, 0}, TreeSize{9, 0.2f, 0}})
            for (const bool gusty : {false, true}) {
                const GrownTree tree(species, size);
                const WindFieldPtr wind =
                    gusty ? gustsOf(8) : std::make_shared<UniformWind>(glm::vec3(5, 3, 0));
                for (const auto level : {ModalMotion::Level::Near, ModalMotion::Level::Far})
                    EXPECT_LT(leanErrors(tree, *wind, level).relative(), 0.07f)
                        << species.name << ", " << size.height << " m, "
                        << (gusty ? "gusts" : "a steady wind");
            }
}

TEST(ModalLean, MatchesBareTrees) {
    for (const char* name : {"oak", "European larch"})
        EXPECT_LT(leanErrors(GrownTree(name, {18, 0.3f, 0}, 0.0f), *gustsOf(12), ModalMotion::Level::Near)
                      .relative(),
                  0.2f)
            << name;
}

TEST(ModalLean, AModelWithoutLeavesUsesItsUnits) {
    Species species = *findSpecies("oak");
    species.tree.leaves.clustersPerBranch = 0;
    const GrownTree tree(species, {18, 0.3f, 0}, 0.0f);
    ModalMotion::Tree placed;
    placed.form = tree.form();
    ModalMotion motion({placed}, 1.0f, runInTurn);
    const UniformWind wind({10, 0, 0});
    for (int i = 1; i <= 600; ++i)
        motion.step(&wind, i / 60.0, 1.0f / 60.0f);
    EXPECT_GT(motion.lean(0).x, 0.01f);
    EXPECT_LT(std::abs(motion.lean(0).y), 0.3f * motion.lean(0).x);
}

} // namespace
} // namespace osgTreeWind
