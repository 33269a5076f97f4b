// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/AxisPaces.h>

#include <osgTreeWind/model/UnitVectors.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>

#include <Eigen/Eigenvalues>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

constexpr std::size_t slicesPerUnit = 4;
constexpr Eigen::Index krylovSize = 6;
constexpr double heaviestShare = 0.75; ///< A tree that leans so far on its stiffness still has half its pace.

/// A short piece of a unit: its mass and its bending are in the middle.
struct Slice {
    std::size_t parent; ///< Index of the slice it goes on from; its own index for the first one of a tree.
    double rootGive;    ///< rad/(N m), of what holds the unit it is part of.
    glm::dvec3 place;
    glm::dvec3 direction;
    double mass;
    double flexibility; ///< rad/(N m)
};

double atLeast(double value, double least) {
    return value > least ? value : least;
}

/// The slice of a unit that has bent last before `attach`.
std::size_t sliceAt(std::size_t unit, float attach) {
    const double slice = std::clamp(static_cast<double>(attach), 0.0, 1.0) * slicesPerUnit - 0.5;
    return unit * slicesPerUnit + static_cast<std::size_t>(std::max(slice, 0.0));
}

std::vector<Slice> slicesOf(const TreeModel& model, const TreeScale& scale,
                            const std::vector<UnitLoad>& loads) {
    constexpr double count = slicesPerUnit;
    std::vector<Slice> slices;
    slices.reserve(model.skeleton.units.size() * slicesPerUnit);
    for (const BranchUnit& unit : model.skeleton.units) {
        const UnitLoad& load = loads[slices.size() / slicesPerUnit];
        const glm::dvec3 base(scale.axes * unit.base), span(scale.axes * (unit.tip - unit.base));
        const double length = atLeast(glm::length(span), 1e-6);
        const double d0 = atLeast(2.0 * unit.baseRadius * scale.radius, 1e-6);
        const double d1 = atLeast(2.0 * unit.tipRadius * scale.radius, 1e-6);
        for (std::size_t i = 0; i < slicesPerUnit; ++i) {
            const double t = static_cast<double>(i) / count;
            const double a = d0 + (d1 - d0) * t, b = d0 + (d1 - d0) * (t + 1.0 / count);
            Slice slice;
            if (i > 0)
                slice.parent = slices.size() - 1;
            else if (unit.parent >= 0)
                slice.parent = sliceAt(static_cast<std::size_t>(unit.parent), unit.attach);
            else
                slice.parent = slices.size();
            slice.rootGive = load.rootGive;
            slice.place = base + (t + 0.5 / count) * span;
            slice.direction = span / length;
            const double share = (a * a + a * b + b * b) / (d0 * d0 + d0 * d1 + d1 * d1) / count;
            slice.mass = share * load.woodMass + load.leafMass / count;
            slice.flexibility = 64.0 * (a * a + a * b + b * b) * length /
                                (3.0 * glm::pi<double>() * load.modulus * a * a * a * b * b * b * count);
            slices.push_back(slice);
        }
    }
    return slices;
}

/// Of a symmetric matrix of these diagonals, the eigenvalue whose eigenvector has the largest first
/// component.
double strongestEigenvalue(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& besideIt) {
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes;
    modes.computeFromTridiagonal(diagonal, besideIt);
    Eigen::Index best = 0;
    modes.eigenvectors().row(0).cwiseAbs().maxCoeff(&best);
    return modes.eigenvalues()[best];
}

/// Free sway of the slices [first, end), all carried by the first.
class Sway {
public:
    using Shifts = std::vector<glm::dvec3>; // of each slice

    /// @param axis per slice: the axis it is part of. @param own the one that sways. @param foot its base.
    Sway(const std::vector<Slice>& slices, const std::vector<std::size_t>& axis, std::size_t own,
         std::size_t first, std::size_t end, const glm::dvec3& foot, double gravity)
        : _slices(slices), _axis(axis), _own(own), _first(first), _size(end - first), _foot(foot),
          _gravity(gravity), _force(_size), _moment(_size), _turn(_size), _carried(_size) {}

    /// Circular frequency, the mean of both directions across the first slice.
    double speed() {
        const glm::dvec3 along = _slices[_first].direction;
        const glm::dvec3 e1 = perpendicular(along);
        return std::sqrt(2.0 / (slowness(e1) + slowness(glm::cross(e1, along))));
    }

private:
    /// 1 / speed^2 of the mode that takes the largest part when the axis, pulled along `direction` with all
    /// it carries unbent, is let go. By Lanczos' method from that bend.
    double slowness(const glm::dvec3& direction) {
        Shifts before(_size), now = bent(Shifts(_size, direction), true);
        Eigen::VectorXd diagonal(krylovSize),
            besideIt(krylovSize); // of the matrix in the space of those shifts
        const double left = 1.0 - weightShare(now, direction);
        double coupling = 0.0;
        scale(now, 1.0 / std::sqrt(product(now, now)));
        for (Eigen::Index k = 0;; ++k) {
            Shifts next = bent(now, false);
            diagonal[k] = product(next, now);
            for (std::size_t i = 0; i < _size; ++i)
                next[i] -= diagonal[k] * now[i] + coupling * before[i];
            coupling = std::sqrt(product(next, next));
            if (k + 1 == krylovSize || coupling < 1e-6 * diagonal[0])
                return strongestEigenvalue(diagonal.head(k + 1), besideIt.head(k)) / left;
            besideIt[k] = coupling;
            scale(next, 1.0 / coupling);
            before = std::move(now);
            now = std::move(next);
        }
    }

    /// What weight takes of the elastic energy of `shifts`, just bent() by an even load along `direction`:
    /// the work of all parts as they sink, at most heaviestShare; below 0 for what hangs.
    double weightShare(const Shifts& shifts, const glm::dvec3& direction) {
        double elastic = 0.0, work = 0.0;
        for (std::size_t i = _size; i-- > 0;) {
            _carried[i] += mass(i);
            elastic += mass(i) * glm::dot(direction, shifts[i]);
            const glm::dvec3 link = linkTo(i), turn = i > 0 ? _turn[parent(i)] : _rootTurn;
            work += _carried[i] * (glm::dot(turn, turn) * link.z - glm::dot(turn, link) * turn.z);
            if (i > 0)
                _carried[parent(i)] += _carried[i];
        }
        std::fill(_carried.begin(), _carried.end(), 0.0);
        return std::clamp(_gravity * work / elastic, -1.0, heaviestShare);
    }

    double mass(std::size_t i) const { return _slices[_first + i].mass; }
    std::size_t parent(std::size_t i) const { return _slices[_first + i].parent - _first; }
    /// From the slice that carries this one; from the foot of the axis to its first.
    glm::dvec3 linkTo(std::size_t i) const {
        return _slices[_first + i].place - (i > 0 ? _slices[_slices[_first + i].parent].place : _foot);
    }
    /// What bends `slice` of a moment: wood does not twist.
    static glm::dvec3 across(const Slice& slice, const glm::dvec3& moment) {
        return moment - slice.direction * glm::dot(slice.direction, moment);
    }
    double product(const Shifts& a, const Shifts& b) const {
        double sum = 0.0;
        for (std::size_t i = 0; i < _size; ++i)
            sum += mass(i) * glm::dot(a[i], b[i]);
        return sum;
    }
    void scale(Shifts& shifts, double factor) const {
        for (glm::dvec3& shift : shifts)
            shift *= factor;
    }

    /// Shifts under a load of mass times `shift`. @param stiff only the axis itself bends.
    Shifts bent(const Shifts& shift, bool stiff) {
        for (std::size_t i = 0; i < _size; ++i) {
            _force[i] = mass(i) * shift[i];
            _moment[i] = glm::dvec3(0.0);
        }
        for (std::size_t i = _size; i-- > 1;) {
            _moment[parent(i)] += _moment[i] + glm::cross(linkTo(i), _force[i]);
            _force[parent(i)] += _force[i];
        }
        const Slice& first = _slices[_first];
        _rootTurn = first.rootGive * across(first, _moment[0] + glm::cross(linkTo(0), _force[0]));
        Shifts result(_size);
        for (std::size_t i = 0; i < _size; ++i) {
            const Slice& slice = _slices[_first + i];
            const glm::dvec3 turn = i > 0 ? _turn[parent(i)] : _rootTurn;
            result[i] = glm::cross(turn, linkTo(i));
            if (i > 0)
                result[i] += result[parent(i)];
            const bool bends = !stiff || _axis[(_first + i) / slicesPerUnit] == _own;
            _turn[i] = bends ? turn + slice.flexibility * across(slice, _moment[i]) : turn;
        }
        return result;
    }

    const std::vector<Slice>& _slices;
    const std::vector<std::size_t>& _axis;
    const std::size_t _own, _first, _size;
    const glm::dvec3 _foot;
    const double _gravity;
    glm::dvec3 _rootTurn{0.0};
    Shifts _force, _moment, _turn;
    std::vector<double> _carried; ///< Mass, 0 between uses.
};

} // namespace

double jointStiffness(double elasticModulus, double d0, double d1, double length, double reach) {
    const double q0 = reach / d0, q1 = (reach - length) / d1;
    return 3.0 * glm::pi<double>() * elasticModulus * d0 * d1 * reach * reach /
           (64.0 * length * (q0 * q0 + q0 * q1 + q1 * q1));
}

std::vector<double> axisPaces(const TreeModel& model, const TreeScale& scale,
                              const std::vector<UnitLoad>& loads, double gravity) {
    const std::vector<BranchUnit>& units = model.skeleton.units;
    const std::vector<Slice> slices = slicesOf(model, scale, loads);
    const auto parent = [&](std::size_t i) { return static_cast<std::size_t>(units[i].parent); };
    std::vector<std::size_t> axis(units.size()), ends(units.size(), 0); // what a unit carries is one run
    for (std::size_t i = 0; i < units.size(); ++i)
        axis[i] = carriesOn(units, i) ? axis[parent(i)] : i;
    for (std::size_t i = units.size(); i-- > 0;) {
        ends[i] = std::max(ends[i], i + 1);
        if (units[i].parent >= 0)
            ends[parent(i)] = std::max(ends[parent(i)], ends[i]);
    }

    std::vector<double> speeds(units.size());
    for (std::size_t i = 0; i < units.size(); ++i)
        speeds[i] = carriesOn(units, i) ? speeds[parent(i)]
                                        : Sway(slices, axis, i, i * slicesPerUnit, ends[i] * slicesPerUnit,
                                               glm::dvec3(scale.axes * units[i].base), gravity)
                                              .speed();
    return speeds;
}

} // namespace osgTreeWind
