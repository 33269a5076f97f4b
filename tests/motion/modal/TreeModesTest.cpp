// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/motion/modal/TreeModes.h>

#include <tests/motion/GrownTree.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

JointTree::Link linkAt(int parent, const glm::dvec3& base, const glm::dvec3& direction) {
    JointTree::Link link;
    link.parent = parent;
    link.base = base;
    const glm::dvec3 e1 = glm::normalize(glm::dvec3(1, 0, 0) - direction.x * direction);
    link.axes = {glm::cross(direction, e1), glm::cross(direction, glm::cross(e1, direction))};
    return link;
}

JointTree::Point massAt(std::size_t link, const glm::dvec3& base, const glm::dvec3& place, double mass) {
    JointTree::Point point;
    point.link = link;
    point.place = place;
    point.lever = place - base;
    point.mass = mass;
    return point;
}

/// Adds a link with a mass at its end.
void addLink(JointTree& tree, int parent, const glm::dvec3& direction, double length, double mass) {
    const glm::dvec3 base =
        parent < 0 ? glm::dvec3(0.0) : tree.points[static_cast<std::size_t>(parent)].place;
    tree.links.push_back(linkAt(parent, base, direction));
    tree.points.push_back(massAt(tree.links.size() - 1, base, base + length * direction, mass));
}

JointTree pole(int links, double length = 1.0) {
    JointTree tree;
    for (int i = 0; i < links; ++i)
        addLink(tree, i - 1, {0, 0, 1}, length, 1.0);
    return tree;
}

/// A trunk with a bough on each side, in the plane y = 0; the masses are at the boughs' tips.
JointTree forkedTree(double angle) {
    JointTree tree;
    addLink(tree, -1, {0, 0, 1}, 1.0, 0.0);
    addLink(tree, 0, {std::sin(angle), 0, std::cos(angle)}, 1.0, 1.0);
    addLink(tree, 0, {-std::sin(angle), 0, std::cos(angle)}, 1.0, 1.0);
    return tree;
}

/// Random links, with masses and springs over three orders of magnitude.
JointTree randomTree(std::size_t links, unsigned seed) {
    Random random(seed);
    JointTree tree;
    for (std::size_t i = 0; i < links; ++i) {
        const int parent = i == 0 ? -1 : static_cast<int>(random.uniform() * static_cast<float>(i));
        const glm::dvec3 direction =
            glm::normalize(glm::dvec3(random.symmetric(), random.symmetric(), 1.2f + random.symmetric()));
        addLink(tree, parent, direction, 0.3 + random.uniform(), std::pow(10.0, 1.5 * random.symmetric()));
        tree.points.back().lever *= 0.8;
        tree.links.back().stiffness = std::pow(10.0, 1.5 * random.symmetric());
    }
    return tree;
}

Eigen::MatrixXd denseMasses(const JointTree& tree) {
    const auto n = static_cast<Eigen::Index>(tree.jointCount());
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
    for (const JointTree::Point& point : tree.points)
        for (Eigen::Index i = 0; i < n; ++i)
            for (Eigen::Index j = 0; j < n; ++j) {
                const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
                if (carries(tree, a / 2, point.link) && carries(tree, b / 2, point.link))
                    m(i, j) += point.mass * glm::dot(tree.displacement(point, a / 2, a % 2),
                                                     tree.displacement(point, b / 2, b % 2));
            }
    return m;
}

Eigen::VectorXd stiffnesses(const JointTree& tree) {
    Eigen::VectorXd k(static_cast<Eigen::Index>(tree.jointCount()));
    for (Eigen::Index i = 0; i < k.size(); ++i)
        k[i] = tree.links[static_cast<std::size_t>(i) / 2].stiffness;
    return k;
}

TEST(TreeModes, TwoLinksHaveFrequenciesOfSqrtTwoMinusAndPlusOne) {
    const std::vector<TreeMode> modes = lowestModes(pole(2), 4);
    ASSERT_EQ(modes.size(), 4u);
    EXPECT_NEAR(modes[0].omega, std::sqrt(2.0) - 1.0, 1e-9);
    EXPECT_NEAR(modes[1].omega, std::sqrt(2.0) - 1.0, 1e-9);
    EXPECT_NEAR(modes[2].omega, std::sqrt(2.0) + 1.0, 1e-9);
    EXPECT_NEAR(modes[3].omega, std::sqrt(2.0) + 1.0, 1e-9);
}

TEST(TreeModes, AForkMatchesAHandCalculation) {
    // For three equal links at 60 degrees, omega^2 = (7 -+ sqrt 43) / 3; other modes have opposed boughs.
    const std::vector<TreeMode> modes = lowestModes(forkedTree(std::acos(-1.0) / 3.0), 6);
    for (const double expected : {(7.0 - std::sqrt(43.0)) / 3.0, 1.0, (7.0 + std::sqrt(43.0)) / 3.0}) {
        double nearest = 0.0;
        for (const TreeMode& mode : modes)
            if (std::abs(mode.omega * mode.omega - expected) < std::abs(nearest - expected))
                nearest = mode.omega * mode.omega;
        EXPECT_NEAR(nearest, expected, 1e-9);
    }
}

TEST(TreeModes, TheTrunkRestsWhereBoughsSwayAgainstEachOther) {
    bool found = false;
    for (const TreeMode& mode : lowestModes(forkedTree(1.0), 6))
        if (std::abs(mode.omega - 1.0) < 1e-9 && std::abs(mode.angles[2]) > 0.1) {
            found = true;
            EXPECT_NEAR(mode.angles[0], 0.0, 1e-9);
            EXPECT_NEAR(mode.angles[2], -mode.angles[4], 1e-9);
        }
    EXPECT_TRUE(found);
}

TEST(TreeModes, MassMatrixIsTheSumOverAllPoints) {
    const JointTree tree = randomTree(40, 3);
    const Eigen::MatrixXd dense = denseMasses(tree);
    const JointMasses masses(tree);
    const double largest = dense.cwiseAbs().maxCoeff();
    for (std::size_t j = 0; j < tree.jointCount(); ++j) {
        std::vector<double> one(tree.jointCount(), 0.0);
        one[j] = 1.0;
        const std::vector<double> column = masses.times(one);
        for (std::size_t i = 0; i < column.size(); ++i)
            ASSERT_NEAR(column[i], dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                        1e-12 * largest)
                << i << ", " << j;
    }
    std::vector<double> x(tree.jointCount());
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = std::sin(1.0 + static_cast<double>(i));
    const std::vector<double> y = masses.times(x);
    const Eigen::VectorXd expected = dense * Eigen::Map<const Eigen::VectorXd>(x.data(), dense.cols());
    for (std::size_t i = 0; i < x.size(); ++i)
        ASSERT_NEAR(y[i], expected[static_cast<Eigen::Index>(i)], 1e-11 * largest);
}

TEST(TreeModes, AllModesTogetherAreTheFlexibility) {
    // sum of phi phi^T / omega^2 = diag(1 / K)
    const JointTree tree = randomTree(30, 5);
    const auto n = static_cast<Eigen::Index>(tree.jointCount());
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n, n);
    for (const TreeMode& mode : lowestModes(tree, tree.jointCount())) {
        const Eigen::Map<const Eigen::VectorXd> phi(mode.angles.data(), n);
        sum += phi * phi.transpose() / (mode.omega * mode.omega);
    }
    const Eigen::VectorXd k = stiffnesses(tree);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j)
            ASSERT_NEAR(sum(i, j) * std::sqrt(k[i] * k[j]), i == j ? 1.0 : 0.0, 1e-6) << i << ", " << j;
}

TEST(TreeModes, MatchADenseSolver) {
    const JointTree tree = randomTree(300, 7);
    const Eigen::MatrixXd k = stiffnesses(tree).asDiagonal();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> dense(k, denseMasses(tree));
    const std::vector<TreeMode> modes = lowestModes(tree, 32);
    for (std::size_t i = 0; i < 16; ++i)
        EXPECT_NEAR(modes[i].omega / std::sqrt(dense.eigenvalues()[static_cast<Eigen::Index>(i)]), 1.0, 1e-6)
            << i;
    for (std::size_t i = 16; i < 32; ++i)
        EXPECT_NEAR(modes[i].omega / std::sqrt(dense.eigenvalues()[static_cast<Eigen::Index>(i)]), 1.0, 1e-2)
            << i;
}

TEST(TreeModes, ShapesAreMassOrthogonal) {
    const JointTree tree = randomTree(60, 9);
    const JointMasses masses(tree);
    const std::vector<TreeMode> modes = lowestModes(tree, 20);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const std::vector<double> image = masses.times(modes[i].angles);
        for (std::size_t j = 0; j < modes.size(); ++j) {
            double product = 0.0;
            for (std::size_t a = 0; a < image.size(); ++a)
                product += image[a] * modes[j].angles[a];
            EXPECT_NEAR(product, i == j ? 1.0 : 0.0, 1e-8);
        }
    }
}

TEST(TreeModes, ManyLinksMatchAUniformCantilever) {
    const std::vector<TreeMode> modes = lowestModes(pole(200, 0.01), 4);
    EXPECT_NEAR(modes[2].omega / modes[0].omega, 6.267, 0.02);
}

TEST(TreeModes, WeightReducesTheStiffness) {
    // A mass m on a link of length l has W / U = m g l / K, with the opposite sign if it hangs.
    JointTree tree = pole(1, 2.0);
    tree.points[0].mass = 3.0;
    tree.links[0].stiffness = 100.0;
    EXPECT_NEAR(lowestModes(tree, 1)[0].weightShare, 3.0 * 9.81 * 2.0 / 100.0, 1e-12);
    tree.points[0].place.z = tree.points[0].lever.z = -2.0;
    EXPECT_NEAR(lowestModes(tree, 1)[0].weightShare, -3.0 * 9.81 * 2.0 / 100.0, 1e-12);
}

TEST(TreeModes, BucklingMatchesGreenhill) {
    // q l^3 / (E I) = 7.837 for a uniform pole under its own weight.
    const int links = 200;
    const double length = 10.0, buckling = 7.837, stiffness = 1.0e4; // E I
    JointTree tree = pole(links, length / links);
    for (JointTree::Link& link : tree.links)
        link.stiffness = stiffness * links / length;
    for (JointTree::Point& point : tree.points)
        point.mass = buckling * stiffness / std::pow(length, 3.0) * length / links / 9.81;
    EXPECT_NEAR(lowestModes(tree, 1)[0].weightShare, 1.0, 0.02);
}

TEST(TreeModes, AnEmptyTreeHasNone) {
    EXPECT_TRUE(lowestModes(JointTree(), 5).empty());
    EXPECT_EQ(lowestModes(pole(1), 5).size(), 2u);
}

} // namespace
} // namespace osgTreeWind
