// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalModel.h>

#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/modal/DragPatches.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <tests/motion/GrownTree.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

/// A force on each patch, N.
using PatchForces = std::vector<glm::dvec3>;

/// Weak, strong and upward forces, all different.
PatchForces mixedForces(std::size_t patches) {
    PatchForces forces;
    for (std::size_t p = 0; p < patches; ++p) {
        const auto x = static_cast<double>(p);
        forces.emplace_back(50.0 + 30.0 * std::sin(x), 20.0 * std::cos(2.0 * x), 10.0 * std::sin(3.0 * x));
    }
    return forces;
}

/// K^-1 sum of J^T F, with each force distributed over its patch by drag.
std::vector<double> staticAngles(const JointTree& tree, std::size_t patches, const PatchForces& forces) {
    const std::vector<std::size_t> patchOf = dragPatches(tree, patches);
    std::vector<double> area(patches, 0.0), angles(tree.jointCount(), 0.0);
    for (const JointTree::Point& point : tree.points)
        area[patchOf[point.link]] += point.woodDrag + point.leafDrag;
    for (const JointTree::Point& point : tree.points) {
        const std::size_t p = patchOf[point.link];
        const glm::dvec3 force = (point.woodDrag + point.leafDrag) / area[p] * forces[p];
        for (std::size_t i = 0; i < angles.size(); ++i)
            if (carries(tree, i / 2, point.link))
                angles[i] +=
                    glm::dot(tree.displacement(point, i / 2, i % 2), force) / tree.links[i / 2].stiffness;
    }
    return angles;
}

/// [Phi R](q, F) with each mode at its static amplitude under F and weight.
std::vector<double> modalAngles(const ModalModel& model, const PatchForces& forces) {
    std::vector<double> vector(model.columns(), 0.0);
    const std::size_t modes = model.modes.size();
    for (std::size_t p = 0; p < forces.size(); ++p)
        for (std::size_t c = 0; c < 3; ++c) {
            const double force = forces[p][static_cast<int>(c)];
            vector[modes + 3 * p + c] = force;
            for (std::size_t k = 0; k < modes; ++k) {
                const double omega = model.modes[k].omega;
                const double left = Laws().weightLeaves(model.modes[k].weightShare);
                vector[k] += static_cast<double>(model.levers[(3 * p + c) * modes + k]) * force /
                             (omega * omega * left);
            }
        }
    std::vector<double> angles(model.joints, 0.0);
    for (std::size_t i = 0; i < model.joints; ++i)
        for (std::size_t c = 0; c < model.columns(); ++c)
            angles[i] += static_cast<double>(model.poses[i * model.columns() + c]) * vector[c];
    return angles;
}

double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double value : values)
        most = std::max(most, std::abs(value));
    return most;
}

TEST(ModalModel, StaticDeflectionMatchesItsSprings) {
    for (const char* name : {"oak", "Norway spruce", "silver birch"}) {
        const GrownTree tree(name, {18, 0.25f, 0});
        const JointTree joints = tree.joints();
        for (const ModalDetail detail : {ModalDetail{12, 10}, ModalDetail{2, 3}, ModalDetail{16, 28}}) {
            ModalModel model = makeModalModel(joints, tree.material(), detail);
            for (ModalModel::Mode& mode : model.modes)
                mode.weightShare = 0.0f;
            ASSERT_EQ(model.patches.size(), detail.patches);
            const PatchForces forces = mixedForces(detail.patches);
            const std::vector<double> expected = staticAngles(joints, detail.patches, forces),
                                      angles = modalAngles(model, forces);
            const double most = largest(expected);
            for (std::size_t i = 0; i < angles.size(); ++i)
                ASSERT_NEAR(angles[i] / most, expected[i] / most, 1e-4)
                    << name << ", joint " << i << ", " << detail.modes << " modes";
        }
    }
}

/// A forked tree of four units with eight joints, which a model keeps as eight modes.
GrownTree smallTree() {
    Species species = defaultSpecies();
    species.tree.growth.reset();
    species.tree.wood.levels = 1;
    species.tree.wood.trunkUnits = 1;
    species.tree.wood.bareUnits = 0;
    species.tree.wood.childrenPerBranch = 3;
    return {species, {6, 0.1f, 0}};
}

TEST(ModalModel, WithAllModesTheResidualIsZero) {
    const GrownTree tree = smallTree();
    const JointTree joints = tree.joints();
    const ModalModel model = makeModalModel(joints, tree.material(), {16, 4});
    ASSERT_EQ(model.modes.size(), joints.jointCount());
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        PatchForces forces(model.patches.size(), glm::dvec3(0.0));
        for (int axis = 0; axis < 3; ++axis) {
            forces[p] = glm::dvec3(0.0);
            forces[p][axis] = 1.0;
            const double most = largest(staticAngles(joints, forces.size(), forces));
            for (std::size_t i = 0; i < model.joints; ++i)
                EXPECT_NEAR(model.poses[i * model.columns() + model.modes.size() + 3 * p +
                                        static_cast<std::size_t>(axis)],
                            0.0, 1e-6 * most)
                    << "joint " << i << ", patch " << p;
        }
    }
}

TEST(ModalModel, ACoarserModelHasTheFirstModes) {
    const GrownTree tree("beech", {20, 0.3f, 0});
    const std::vector<ModalModel> models =
        makeModalModels(tree.joints(), tree.material(), {ModalDetail{12, 10}, ModalDetail{4, 4}});
    const ModalModel &fine = models[0], &coarse = models[1];
    ASSERT_EQ(coarse.modes.size(), 4u);
    ASSERT_EQ(coarse.patches.size(), 4u);
    for (std::size_t k = 0; k < coarse.modes.size(); ++k) {
        EXPECT_EQ(coarse.modes[k].omega, fine.modes[k].omega);
        EXPECT_EQ(coarse.modes[k].weightShare, fine.modes[k].weightShare);
        for (std::size_t i = 0; i < coarse.joints; ++i)
            ASSERT_EQ(coarse.poses[i * coarse.columns() + k], fine.poses[i * fine.columns() + k])
                << "mode " << k << ", joint " << i;
    }
}

TEST(ModalModel, KeepsTheModesWithMostEnergy) {
    for (const Species& species : SpeciesCatalogue::current().species()) {
        const GrownTree tree(species, {20, 0.3f, 0});
        const ModalModel model = makeModalModel(tree.joints(), tree.material());
        EXPECT_GE(model.modes.size(), 8u) << species.name;
        double sum = 0.0;
        for (const ModalModel::Mode& mode : model.modes) {
            EXPECT_GE(mode.energyShare, 0.0f) << species.name;
            sum += static_cast<double>(mode.energyShare);
        }
        EXPECT_LE(sum, 1.0 + 1e-5) << species.name;
        EXPECT_GT(sum, 0.5) << species.name << " is moved mostly by modes that were not kept";
        EXPECT_TRUE(model.modes.size() == ModalDetail().modes || sum >= 0.95)
            << species.name << " keeps " << model.modes.size() << " modes of share " << sum;
    }
}

TEST(ModalModel, PatchesHaveAllDrag) {
    const GrownTree tree("oak", {20, 0.3f, 0});
    const JointTree joints = tree.joints();
    double wood = 0.0, leaves = 0.0, still = 0.0;
    for (const JointTree::Point& point : joints.points) {
        wood += 0.5 * 1.225 * point.woodDrag;
        leaves += 0.5 * 1.225 * point.leafDrag;
        still += 0.5 * 1.225 * point.stillDrag;
    }
    for (const ModalModel::Patch& patch : makeModalModel(joints, tree.material()).patches) {
        wood -= static_cast<double>(patch.woodDrag);
        leaves -= static_cast<double>(patch.leafDrag);
        still -= static_cast<double>(patch.stillDrag);
    }
    EXPECT_NEAR(wood, 0.0, 1e-5);
    EXPECT_NEAR(leaves, 0.0, 1e-4);
    EXPECT_NEAR(still, 0.0, 1e-4);
}

TEST(ModalModel, AnEmptyTreeMakesAModel) {
    const ModalModel model = makeModalModel(JointTree(), ModalMaterial());
    EXPECT_TRUE(model.modes.empty());
    EXPECT_TRUE(model.poses.empty());
}

constexpr int restSteps = 600;
constexpr float restStep = 0.1f; // seconds

/// Angles at rest in a steady wind.
std::vector<glm::vec2> modalAtRest(const GrownTree& tree, const glm::vec3& wind) {
    const UniformWind field(wind);
    ModalMotion::Tree placed;
    placed.form = tree.form();
    ModalMotion motion({placed}, 1.0f, runInTurn, true);
    motion.sampleWind(&field, 0.0);
    for (int i = 1; i <= restSteps; ++i)
        motion.step(&field, 0.0, restStep);
    std::vector<glm::vec2> angles(tree.units().size());
    motion.angles(0, angles.data());
    return angles;
}

/// Compares the trunk with the statics of its joints; valid without streamlining and without weight.
void expectTrunkAsStaticsSay(const GrownTree& tree, const glm::vec3& wind) {
    const Archetype archetype(tree.form());
    PatchForces forces;
    for (const ModalModel::Patch& patch : archetype.model(0).patches)
        forces.push_back(static_cast<double>((patch.woodDrag + patch.leafDrag) * glm::length(wind)) *
                         glm::dvec3(wind));
    const std::vector<double> expected = staticAngles(tree.joints(), forces.size(), forces);
    const std::vector<glm::vec2> angles = modalAtRest(tree, wind);
    const double most = std::hypot(expected[0], expected[1]);
    ASSERT_GT(most, 1e-3);
    for (std::size_t i = 0; i < angles.size(); ++i)
        if (tree.units()[i].level == 0) {
            EXPECT_NEAR(static_cast<double>(angles[i].x) / most, expected[2 * i] / most, 3e-4)
                << "unit " << i;
            EXPECT_NEAR(static_cast<double>(angles[i].y) / most, expected[2 * i + 1] / most, 3e-4)
                << "unit " << i;
        }
}

/// A species with nearly massless wood, without allometry and with rigid roots. Below 10 m/s its leaves do
/// not streamline.
Species weightless(Species species) {
    species.wood.density = 0.01f;
    species.wood.leafMass = 0.0f;
    species.wood.branchWood = WoodAllometry::Drawn;
    species.wood.anchorage = 0.0f;
    species.wood.breezeStreamlining = 0.0f;
    return species;
}

TEST(ModalModel, APoleInTheWindMatchesStatics) {
    GrownTree pole = smallTree();
    pole.species = weightless(pole.species);
    pole.species.wood.dampingRatio = 0.3f;
    pole.model = TreeModel();
    for (int i = 0; i < 5; ++i) {
        const auto base = static_cast<float>(i);
        pole.model.skeleton.units.push_back(
            {i - 1, 0, {0, 0, base}, {0, 0, base + 1.0f}, 0.03f - 0.004f * base, 0.026f - 0.004f * base});
    }
    pole.scale = {};
    expectTrunkAsStaticsSay(pole, {9.5f, 0.0f, 0.0f});
    expectTrunkAsStaticsSay(pole, {0.0f, -6.0f, 0.0f});
}

/// A light pole with a mass and drag at its top.
JointTree weightedPole(int links, double length, double bending, double mass) {
    JointTree tree;
    for (int i = 0; i < links; ++i) {
        JointTree::Link link;
        link.parent = i - 1;
        link.base = {0.0, 0.0, i * length / links};
        // The halves of a link bend before and after its joint; the joint at the foot has one half only.
        link.stiffness = bending * links / length * (i == 0 ? 2.0 : 1.0);
        tree.links.push_back(link);
        JointTree::Point point;
        point.link = static_cast<std::size_t>(i);
        point.place = {0.0, 0.0, (i + 1) * length / links};
        point.lever = point.place - link.base;
        point.mass = 1e-3 * mass / links;
        if (i == links - 1) {
            point.mass = mass;
            point.woodDrag = 1.0;
        }
        tree.points.push_back(point);
    }
    return tree;
}

TEST(ModalModel, ALoadedColumnMatchesTimoshenko) {
    // The top of a column of length l with an axial load P and a transverse load Q moves by Q l^3 / (3 E I)
    // times 3 (tan u - u) / u^3, u = l sqrt(P / (E I)) (Timoshenko and Gere 1961). The pole weighs P / 1000.
    const double length = 12.0, bending = 2.0e5, push = 20.0, pi = 3.141592653589793;
    for (const double share : {0.1, 0.3, 0.6}) {
        const double load = share * 0.25 * pi * pi * bending / (length * length);
        const JointTree tree = weightedPole(100, length, bending, load / gravity);
        const ModalModel model = makeModalModel(tree, ModalMaterial(), {12, 1});
        const std::vector<double> angles = modalAngles(model, {glm::dvec3(push, 0.0, 0.0)});
        double top = 0.0;
        for (std::size_t i = 0; i < angles.size(); ++i)
            top += angles[i] * tree.displacement(tree.points.back(), i / 2, i % 2).x;
        const double u = length * std::sqrt(load / bending);
        const double expected = push * std::pow(length, 3.0) / bending * (std::tan(u) - u) / std::pow(u, 3.0);
        EXPECT_NEAR(top / expected, 1.0, 0.015) << "weight is " << share << " of what buckles";
    }
}

TEST(ModalModel, TheTrunkOfATreeInTheWindMatchesStatics) {
    for (const char* name : {"oak", "Norway spruce"}) {
        Species species = weightless(*findSpecies(name));
        species.tree.growth.reset();
        species.tree.wood.crook = species.tree.wood.jitter = 0.0f; // an upright trunk
        species.wood.dampingRatio = 0.3f;                          // shortens the transient
        SCOPED_TRACE(name);
        expectTrunkAsStaticsSay({species, {18, 0.25f, 0}}, {8.0f, 0.0f, 0.0f});
    }
}

} // namespace
} // namespace osgTreeWind
