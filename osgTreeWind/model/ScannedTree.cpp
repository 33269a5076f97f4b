// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/ScannedTree.h>

#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/model/ScanAxes.h>
#include <osgTreeWind/model/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr double shortestBranch = 1e-3; // branch, over the tree's height

double frustum(double length, double a, double b) {
    return glm::pi<double>() / 3.0 * length * (a * a + a * b + b * b);
}

/// Arc lengths at which an axis is cut into units, both ends among them: halves of halves, until none is
/// longer than `longest` or crooked.
std::vector<double> cutsOf(const ScanLine& line, double longest) {
    constexpr double straightest = 0.88; // of chord over arc: an arc of 100 degrees
    constexpr double most = 64.0;
    longest = std::max(longest, line.length() / most);
    std::vector<double> cuts = {0.0}, ends = {line.length()}; // those to come, the next one last
    while (!ends.empty()) {
        const double from = cuts.back(), to = ends.back(), length = to - from;
        const bool isCrooked = glm::distance(line.at(from), line.at(to)) < straightest * length;
        if (length > longest || (isCrooked && length > 0.25 * longest)) {
            ends.push_back(0.5 * (from + to));
        } else {
            cuts.push_back(to);
            ends.pop_back();
        }
    }
    return cuts;
}

/// Radii at the cuts, fitted to those of the axis by least squares, tapering.
std::vector<double> fittedRadii(const ScanAxis& axis, const std::vector<double>& cuts) {
    const std::size_t count = cuts.size() - 1;
    // Normal equations of a line with bends at the cuts; tridiagonal.
    std::vector<double> diagonal(count + 1, 0.0), beside(count + 1, 0.0), right(count + 1, 0.0);
    std::size_t stretch = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const double from = cuts[i], to = cuts[i + 1], length = to - from;
        double t = 0.0;
        for (;; ++stretch) {
            const double end = axis.line.arc[stretch + 1];
            const bool isLast = end >= to || stretch + 1 == axis.radii.size();
            const double u = isLast ? 1.0 : (end - from) / length;
            const double first = length * (u - t), second = length * 0.5 * (u * u - t * t),
                         third = length * (u * u * u - t * t * t) / 3.0;
            diagonal[i] += first - 2.0 * second + third;
            diagonal[i + 1] += third;
            beside[i] += second - third;
            right[i] += axis.radii[stretch] * (first - second);
            right[i + 1] += axis.radii[stretch] * second;
            t = u;
            if (isLast)
                break;
        }
    }
    for (std::size_t i = 1; i <= count; ++i) {
        const double factor = beside[i - 1] / diagonal[i - 1];
        diagonal[i] -= factor * beside[i - 1];
        right[i] -= factor * right[i - 1];
    }
    std::vector<double> radii(count + 1);
    for (std::size_t i = count + 1; i-- > 0;)
        radii[i] = (right[i] - (i < count ? beside[i] * radii[i + 1] : 0.0)) / diagonal[i];
    radii[0] = std::max(radii[0], axis.radii.front());
    for (std::size_t i = 1; i <= count; ++i)
        radii[i] = glm::clamp(radii[i], 0.2 * radii[i - 1], radii[i - 1]);
    return radii;
}

class SkeletonMaker {
public:
    SkeletonMaker(std::vector<ScanAxis> axes, const ScanDetail& detail)
        : _axes(std::move(axes)), _detail(detail), _branches(_axes.size()), _cuts(_axes.size()) {
        _detail.ringsPerBranch = glm::clamp(detail.ringsPerBranch, 2, 64);
        _detail.mostUnits = std::min<std::size_t>(detail.mostUnits, 4096);
        for (const ScanAxis& axis : _axes)
            for (const glm::dvec3& point : axis.line.points)
                _height = std::max(_height, point.z);
        choose();
    }

    ScannedTree make() {
        _tree.skeleton.ringsPerBranch = _detail.ringsPerBranch;
        _tree.skeleton.joined = true;
        grow(0, -1, 1.0f);
        ScanReport& report = _tree.report;
        for (std::size_t i = 0; i < _axes.size(); ++i) {
            report.cylinders += _axes[i].cylinders;
            report.cylinderVolume += _axes[i].volume;
            report.taken += isTaken(i) ? _axes[i].cylinders : 0;
        }
        report.units = _tree.skeleton.units.size();
        report.height = _height;
        report.woodVolume = woodVolume(_tree.skeleton);
        report.baseDiameter = 2.0 * static_cast<double>(_tree.skeleton.units.front().baseRadius);
        return std::move(_tree);
    }

private:
    /// Decides which axes are taken, and as how many units each.
    void choose() {
        const double longest = 0.125 * _height;
        std::vector<double> thickness(_axes.size());
        std::vector<std::size_t> order(_axes.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (std::size_t i = 0; i < _axes.size(); ++i) {
            const ScanAxis& axis = _axes[i];
            thickness[i] = axis.radii.front();
            if (axis.parent >= 0) // taken after its parent
                thickness[i] = std::min(thickness[i], thickness[static_cast<std::size_t>(axis.parent)]);
        }
        std::stable_sort(order.begin(), order.end(),
                         [&](std::size_t a, std::size_t b) { return thickness[a] > thickness[b]; });
        std::size_t count = 0;
        const auto take = [&](std::size_t i) {
            std::vector<double> cuts = cutsOf(_axes[i].line, longest);
            if (count > 0 && count + cuts.size() - 1 > _detail.mostUnits)
                return false;
            count += cuts.size() - 1;
            _cuts[i] = std::move(cuts);
            if (_axes[i].parent >= 0)
                _branches[static_cast<std::size_t>(_axes[i].parent)].push_back(i);
            return true;
        };
        for (const std::size_t i : wayUp())
            if (!take(i))
                break;
        for (const std::size_t i : order) {
            if (isTaken(i) || !isTaken(static_cast<std::size_t>(_axes[i].parent)) ||
                _axes[i].line.length() < shortestBranch * _height)
                continue;
            if (thickness[i] < _detail.thinnest || !take(i))
                break;
        }
        for (std::vector<std::size_t>& branches : _branches)
            std::sort(branches.begin(), branches.end(), [&](std::size_t a, std::size_t b) {
                return std::make_pair(_axes[a].attach, a) < std::make_pair(_axes[b].attach, b);
            });
    }

    /// The axes from the trunk to the highest point.
    std::vector<std::size_t> wayUp() const {
        const auto reaches = [&](const glm::dvec3& point) { return point.z >= _height; };
        std::size_t highest = 0;
        for (std::size_t i = 0; i < _axes.size(); ++i)
            if (std::any_of(_axes[i].line.points.begin(), _axes[i].line.points.end(), reaches))
                highest = i;
        std::vector<std::size_t> way;
        for (int i = static_cast<int>(highest); i >= 0; i = _axes[static_cast<std::size_t>(i)].parent)
            way.push_back(static_cast<std::size_t>(i));
        return {way.rbegin(), way.rend()};
    }

    bool isTaken(std::size_t axis) const { return !_cuts[axis].empty(); }

    /// Radii at the cuts of an axis: of the volume of its cylinders, at most `thickest`.
    std::vector<double> radiiOf(std::size_t index, double thickest) const {
        const ScanAxis& axis = _axes[index];
        const std::vector<double>& cuts = _cuts[index];
        std::vector<double> radii = fittedRadii(axis, cuts);
        double volume = 0.0;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double arc = cuts[i + 1] - cuts[i],
                         chord = glm::distance(axis.line.at(cuts[i]), axis.line.at(cuts[i + 1]));
            volume += frustum(0.5 * (arc + chord), radii[i], radii[i + 1]);
        }
        const double factor = std::sqrt(axis.volume / volume);
        for (double& radius : radii)
            radius = glm::clamp(factor * radius, 1e-5 * _height, thickest);
        return radii;
    }

    /// Adds the units of an axis, each followed by what springs from it.
    /// @param attach on the unit `parent`.
    void grow(std::size_t index, int parent, float attach) {
        const ScanAxis& axis = _axes[index];
        const std::vector<double>& cuts = _cuts[index];
        const double thickest = parent < 0 ? axis.radii.front() * 2.0 : radiusAt(parent, attach);
        const std::vector<double> radii = radiiOf(index, thickest);
        auto branch = _branches[index].begin();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double from = cuts[i], to = cuts[i + 1];
            BranchUnit unit;
            unit.parent = parent;
            unit.level = axis.order;
            unit.attach = i == 0 ? attach : 1.0f;
            unit.base = parent < 0 ? glm::vec3(0.0f) : pointAt(parent, unit.attach);
            unit.baseRadius = static_cast<float>(radii[i]);
            unit.tipRadius = static_cast<float>(radii[i + 1]);
            parent = add(unit, axis.line, from, to);
            const bool isLast = i + 2 == cuts.size();
            for (; branch != _branches[index].end() && (isLast || _axes[*branch].attach <= to); ++branch) {
                const double t = (_axes[*branch].attach - from) / (to - from);
                grow(*branch, parent, static_cast<float>(glm::clamp(t, 0.02, 1.0)));
            }
        }
    }

    /// Appends a unit and its points, which follow the line. @return its index.
    int add(BranchUnit unit, const ScanLine& line, double from, double to) {
        const int last = _detail.ringsPerBranch - 1;
        std::vector<glm::vec3> points = {unit.base};
        for (int i = 1; i <= last; ++i)
            points.emplace_back(line.at(glm::mix(from, to, static_cast<double>(i) / last)));
        if (isFolded(points, static_cast<float>(to - from)))
            straighten(points, static_cast<float>(to - from));
        unit.tip = points.back();
        _tree.skeleton.units.push_back(unit);
        _tree.skeleton.points.insert(_tree.skeleton.points.end(), points.begin(), points.end());
        return static_cast<int>(_tree.skeleton.units.size()) - 1;
    }

    /// Whether points lie so near together that the line between them has no clear direction.
    static bool isFolded(const std::vector<glm::vec3>& points, float length) {
        const float nearest = 0.1f * length / static_cast<float>(points.size() - 1);
        for (std::size_t i = 0; i < points.size(); ++i)
            if (glm::distance(points[i > 0 ? i - 1 : 0], points[std::min(i + 1, points.size() - 1)]) <
                nearest)
                return true;
        return glm::distance(points.front(), points.back()) < 0.1f * length;
    }

    static void straighten(std::vector<glm::vec3>& points, float length) {
        const glm::vec3 base = points.front();
        glm::vec3 along = points.back() - base;
        if (glm::length(along) < 0.1f * length)
            along = 0.1f * length * directionOr(along / length, glm::vec3(0.0f, 0.0f, 1.0f));
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = base + along * (static_cast<float>(i) / static_cast<float>(points.size() - 1));
    }

    glm::vec3 pointAt(int unit, float along) const {
        const float place = along * static_cast<float>(_detail.ringsPerBranch - 1);
        const int ring = std::min(static_cast<int>(place), _detail.ringsPerBranch - 2);
        const auto index = static_cast<std::size_t>(unit);
        const float part = place - static_cast<float>(ring);
        const glm::vec3& after = _tree.skeleton.point(index, ring + 1);
        return part >= 1.0f ? after : glm::mix(_tree.skeleton.point(index, ring), after, part);
    }

    double radiusAt(int unit, float along) const {
        const BranchUnit& carrier = _tree.skeleton.units[static_cast<std::size_t>(unit)];
        return static_cast<double>(glm::mix(carrier.baseRadius, carrier.tipRadius, along));
    }

    std::vector<ScanAxis> _axes;
    ScanDetail _detail;
    std::vector<std::vector<std::size_t>> _branches; ///< Axes taken that spring from an axis, upward.
    std::vector<std::vector<double>> _cuts;          ///< Of each axis; none: pruned.
    double _height = 0.0;
    ScannedTree _tree;
};

} // namespace

Result<ScannedTree> makeScannedTree(const ScanCylinders& cylinders, const ScanDetail& detail) {
    if (auto problem = problemOfScan(cylinders))
        return std::move(*problem);
    return SkeletonMaker(axesOfScan(cylinders), detail).make();
}

double woodVolume(const Skeleton& skeleton) {
    double volume = 0.0;
    for (std::size_t unit = 0; unit < skeleton.units.size(); ++unit)
        for (int ring = 1; ring < skeleton.ringsPerBranch; ++ring)
            volume += frustum(static_cast<double>(
                                  glm::distance(skeleton.point(unit, ring - 1), skeleton.point(unit, ring))),
                              static_cast<double>(skeleton.radius(unit, ring - 1)),
                              static_cast<double>(skeleton.radius(unit, ring)));
    return volume;
}

} // namespace osgTreeWind
