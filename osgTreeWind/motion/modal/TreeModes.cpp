// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/TreeModes.h>

#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>

#include <Eigen/Dense>
#include <Eigen/Sparse>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr std::size_t startVectors = 4;
constexpr std::size_t smallestSpace = 72;

/// Mass moments of the points beyond a joint, about the base of its link.
struct CarriedMass {
    double mass = 0.0;
    glm::dvec3 first{0.0};  ///< Sum of m r.
    glm::dmat3 second{0.0}; ///< Sum of m r r^T.

    /// The moments about a point at `-shift`.
    CarriedMass from(const glm::dvec3& shift) const {
        return {mass, first + mass * shift,
                second + glm::outerProduct(first, shift) + glm::outerProduct(shift, first) +
                    mass * glm::outerProduct(shift, shift)};
    }
    void add(const CarriedMass& other) {
        mass += other.mass;
        first += other.first;
        second += other.second;
    }
};

double trace(const glm::dmat3& m) {
    return m[0][0] + m[1][1] + m[2][2];
}

std::vector<double> weightShares(const JointTree& tree, const Eigen::MatrixXd& angles,
                                 const Eigen::VectorXd& energies) {
    const std::size_t count = tree.links.size();
    std::vector<double> mass(count);
    std::vector<glm::dvec3> moment(count,
                                   glm::dvec3(0.0)); // of all that hangs on a link, where it is fixed to it
    for (const JointTree::Point& point : tree.points) {
        mass[point.link] += point.mass;
        moment[point.link] += point.mass * (point.place - tree.links[point.link].base);
    }
    for (std::size_t i = count; i-- > 0;)
        if (tree.links[i].parent >= 0) {
            const auto parent = static_cast<std::size_t>(tree.links[i].parent);
            mass[parent] += mass[i];
            moment[parent] += mass[i] * (tree.links[i].base - tree.links[parent].base);
        }
    std::vector<double> shares;
    std::vector<glm::dvec3> turn(count);
    for (Eigen::Index k = 0; k < angles.cols(); ++k) {
        double work = 0.0;
        for (std::size_t i = 0; i < count; ++i) {
            const JointTree::Link& link = tree.links[i];
            turn[i] = link.parent >= 0 ? turn[static_cast<std::size_t>(link.parent)] : glm::dvec3(0.0);
            for (std::size_t axis = 0; axis < 2; ++axis)
                turn[i] += angles(static_cast<Eigen::Index>(2 * i + axis), k) * link.axes[axis];
            work += glm::dot(turn[i], turn[i]) * moment[i].z - glm::dot(turn[i], moment[i]) * turn[i].z;
        }
        shares.push_back(gravity * work / energies[k]);
    }
    return shares;
}

/// to += factor * from. Each element has a sum of its own, so compilers use vectors without reordering any.
void addMultiple(double* to, double factor, const double* from, Eigen::Index size) {
    for (Eigen::Index i = 0; i < size; ++i)
        to[i] += factor * from[i];
}

/// A basis by columns and by rows, so that all sums run along memory.
struct Basis {
    Eigen::MatrixXd columns;
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> rows;

    /// Subtracts from a vector its projection onto the first columns.
    void removeFrom(Eigen::VectorXd& vector, Eigen::Index count) const {
        Eigen::VectorXd parts = Eigen::VectorXd::Zero(count);
        for (Eigen::Index i = 0; i < vector.size(); ++i)
            addMultiple(parts.data(), vector[i], rows.row(i).data(), count);
        for (Eigen::Index j = 0; j < count; ++j)
            addMultiple(vector.data(), -parts[j], columns.col(j).data(), vector.size());
    }
    void set(Eigen::Index column, const Eigen::VectorXd& vector) {
        columns.col(column) = vector;
        rows.col(column) = vector;
    }
    /// The lower half of its transpose times a matrix.
    Eigen::MatrixXd transposeTimes(const Eigen::MatrixXd& matrix) const {
        const Eigen::Index size = columns.cols();
        Eigen::MatrixXd result = Eigen::MatrixXd::Zero(size, size);
        for (Eigen::Index j = 0; j < size; ++j)
            for (Eigen::Index i = 0; i < columns.rows(); ++i)
                addMultiple(&result(j, j), matrix(i, j), &rows(i, j), size - j);
        return result;
    }
};

/// An orthonormal basis of the Krylov space of `a`, and its images under `a`.
void krylovSpace(const Eigen::SparseMatrix<double>& a, std::size_t size, Basis& basis,
                 Eigen::MatrixXd& images) {
    const Eigen::Index n = a.rows(), m = static_cast<Eigen::Index>(size);
    Random random(1);
    basis.columns.resize(n, m);
    basis.rows.resize(n, m);
    images.resize(n, m);
    for (Eigen::Index filled = 0, worked = 0; worked < m;) {
        if (filled < m) {
            Eigen::VectorXd next(n);
            if (filled < static_cast<Eigen::Index>(startVectors))
                for (Eigen::Index i = 0; i < n; ++i)
                    next[i] = random.symmetric();
            else
                next = images.col(filled - static_cast<Eigen::Index>(startVectors));
            double norm = next.norm();
            for (;;) {
                basis.removeFrom(next, filled);
                double left = next.norm();
                if (left < 0.5 * norm) { // orthogonalize again against rounding (Kahan: twice is enough)
                    basis.removeFrom(next, filled);
                    left = next.norm();
                }
                if (left > 1e-10 * norm && left > 0.0) {
                    basis.set(filled, next / left);
                    break;
                }
                for (Eigen::Index i = 0; i < n; ++i) // the space is exhausted: continue with a random vector
                    next[i] = random.symmetric();
                norm = next.norm();
            }
            ++filled;
        }
        if (filled == m || filled - worked >= static_cast<Eigen::Index>(startVectors)) {
            images.col(worked) = a * basis.columns.col(worked);
            ++worked;
        }
    }
}

} // namespace

JointMasses::JointMasses(const JointTree& tree) : _size(tree.jointCount()) {
    const std::size_t count = tree.links.size();
    std::vector<CarriedMass> own(count);                  // points of the link itself
    std::vector<CarriedMass> beyond(count);               // all descendants of the link
    std::vector<glm::dvec3> bent(count, glm::dvec3(0.0)); // sum of m lever
    std::vector<glm::dmat3> bentBent(count, glm::dmat3(0.0)), bentOwn(count, glm::dmat3(0.0));
    for (const JointTree::Point& point : tree.points) {
        const std::size_t i = point.link;
        const glm::dvec3 r = point.place - tree.links[i].base;
        own[i].add({point.mass, point.mass * r, point.mass * glm::outerProduct(r, r)});
        bent[i] += point.mass * point.lever;
        bentBent[i] += point.mass * glm::outerProduct(point.lever, point.lever);
        bentOwn[i] += point.mass * glm::outerProduct(point.lever, r);
    }
    for (std::size_t i = count; i-- > 0;)
        if (tree.links[i].parent >= 0) {
            const auto parent = static_cast<std::size_t>(tree.links[i].parent);
            CarriedMass all = own[i];
            all.add(beyond[i]);
            beyond[parent].add(all.from(tree.links[i].base - tree.links[parent].base));
        }
    for (std::size_t i = 0; i < count; ++i)
        for (int c = static_cast<int>(i); c >= 0; c = tree.links[static_cast<std::size_t>(c)].parent) {
            const auto carrier = static_cast<std::size_t>(c);
            const glm::dvec3 shift = tree.links[i].base - tree.links[carrier].base;
            const glm::dvec3 first = beyond[i].first + bent[i]; // sum of m r, r the arm about joint i
            // Sum of m r s^T, s the arm about the carrier's joint.
            const glm::dmat3 arms = carrier == i
                                        ? beyond[i].second + bentBent[i]
                                        : beyond[i].second + bentOwn[i] + glm::outerProduct(first, shift);
            Block block{i, carrier, {}};
            for (std::size_t p = 0; p < 2; ++p)
                for (std::size_t q = 0; q < 2; ++q) {
                    const glm::dvec3 a = tree.links[i].axes[p], b = tree.links[carrier].axes[q];
                    // (a x r).(b x s) = (a.b)(r.s) - (a.s)(b.r)
                    block.m[p][q] = glm::dot(a, b) * trace(arms) - glm::dot(b, arms * a);
                }
            _blocks.push_back(block);
        }
}

std::vector<double> JointMasses::times(const std::vector<double>& x) const {
    std::vector<double> y(_size, 0.0);
    for (const Block& block : _blocks)
        for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t q = 0; q < 2; ++q) {
                const std::size_t i = 2 * block.link + p, j = 2 * block.carrier + q;
                y[i] += block.m[p][q] * x[j];
                if (block.link != block.carrier)
                    y[j] += block.m[p][q] * x[i];
            }
    return y;
}

std::vector<TreeMode> lowestModes(const JointTree& tree, std::size_t count) {
    const std::size_t joints = tree.jointCount();
    count = std::min(count, joints);
    if (count == 0)
        return {};
    // K^-1/2 M K^-1/2, whose largest eigenvalues are 1 / omega^2.
    const JointMasses masses(tree);
    Eigen::VectorXd root(static_cast<Eigen::Index>(joints));
    for (std::size_t i = 0; i < joints; ++i)
        root[static_cast<Eigen::Index>(i)] = 1.0 / std::sqrt(tree.links[i / 2].stiffness);
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(8 * masses._blocks.size());
    for (const JointMasses::Block& block : masses._blocks)
        for (std::size_t p = 0; p < 2; ++p)
            for (std::size_t q = 0; q < 2; ++q) {
                const auto i = static_cast<int>(2 * block.link + p),
                           j = static_cast<int>(2 * block.carrier + q);
                const double value = block.m[p][q] * root[i] * root[j];
                entries.emplace_back(i, j, value);
                if (block.link != block.carrier)
                    entries.emplace_back(j, i, value);
            }
    Eigen::SparseMatrix<double> a(static_cast<Eigen::Index>(joints), static_cast<Eigen::Index>(joints));
    a.setFromTriplets(entries.begin(), entries.end());

    Basis basis;
    Eigen::MatrixXd images;
    krylovSpace(a, std::min(joints, std::max(smallestSpace, 9 * count / 4)), basis, images);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> ritz(basis.transposeTimes(images));
    const auto kept = static_cast<Eigen::Index>(count);
    const Eigen::VectorXd slowness = ritz.eigenvalues().tail(kept).reverse();
    Eigen::MatrixXd angles = basis.columns * ritz.eigenvectors().rightCols(kept).rowwise().reverse();
    Eigen::VectorXd energies(kept); // 2 U of each mode
    for (Eigen::Index k = 0; k < kept; ++k) {
        angles.col(k) = root.cwiseProduct(angles.col(k)) / std::sqrt(slowness[k]);
        energies[k] = 1.0 / slowness[k];
    }
    const std::vector<double> weight = weightShares(tree, angles, energies);

    std::vector<TreeMode> modes(count);
    for (std::size_t k = 0; k < count; ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        modes[k].omega = std::sqrt(energies[column]);
        modes[k].weightShare = weight[k];
        modes[k].angles.assign(angles.col(column).data(), angles.col(column).data() + joints);
    }
    return modes;
}

} // namespace osgTreeWind
