// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/AxesSkeleton.h>

#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/CheckScan.h>
#include <osgTreeWind/model/WoodVolume.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {
namespace {

constexpr double minBranchLength = 1e-3; // over the tree's height
constexpr double shootTolerance = 0.5;   // tolerance of the course of a shoot, over its radius

/// Radius of an axis at an arc length; where segments meet, that of the first.
double radiusOf(const WoodAxis& axis, double along) {
    const std::vector<double>& arc = axis.line.arc;
    const auto end = std::lower_bound(arc.begin() + 1, arc.end() - 1, along);
    return axis.radii[static_cast<std::size_t>(end - arc.begin()) - 1];
}

/// Whether a trunk thins much between two arc lengths, as it does where it divides into limbs.
bool hasNeck(const WoodAxis& trunk, double from, double to) {
    constexpr double thinnest = 0.6; // radius over that at `from`
    constexpr double top = 0.3;      // radius over that at the foot, where any trunk thins
    const double thickness = radiusOf(trunk, from);
    return thickness > top * trunk.radii.front() && radiusOf(trunk, to) < thinnest * thickness;
}

/// Arc lengths at which an axis is cut into units, both ends included. Halves it until no unit is longer than
/// `longest`, crooked, or the neck of a trunk.
std::vector<double> computeCuts(const WoodAxis& axis, double longest) {
    constexpr double straightest = 0.88;                        // chord over arc: an arc of 100 degrees
    constexpr double shortestBend = 0.25, shortestNeck = 0.125; // over `longest`; halves may be shorter
    constexpr double most = 64.0;
    const WoodLine& line = axis.line;
    longest = std::max(longest, line.length() / most);
    std::vector<double> cuts = {0.0}, ends = {line.length()}; // ends: a stack of pending cuts
    while (!ends.empty()) {
        const double from = cuts.back(), to = ends.back(), length = to - from;
        const bool isCrooked = glm::distance(line.at(from), line.at(to)) < straightest * length;
        if (length > longest || (isCrooked && length > shortestBend * longest) ||
            (axis.parent < 0 && length > shortestNeck * longest && hasNeck(axis, from, to))) {
            ends.push_back(0.5 * (from + to));
        } else {
            cuts.push_back(to);
            ends.pop_back();
        }
    }
    return cuts;
}

/// Radii at the cuts: a least squares fit to those of the axis, made to taper.
std::vector<double> fittedRadii(const WoodAxis& axis, const std::vector<double>& cuts) {
    const std::size_t count = cuts.size() - 1;
    // Normal equations of a piecewise linear function with nodes at the cuts; tridiagonal.
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
    SkeletonMaker(std::vector<WoodAxis> axes, const WoodDetail& detail)
        : _axes(std::move(axes)), _detail(detail), _branches(_axes.size()), _cuts(_axes.size()),
          _isShoot(_axes.size()) {
        _detail.ringsPerBranch = glm::clamp(detail.ringsPerBranch, 2, 64);
        _detail.maxUnits = std::min(detail.maxUnits, maxScanUnits);
        _detail.maxShoots = std::min(detail.maxShoots, maxScanShoots);
        for (const WoodAxis& axis : _axes)
            for (const glm::dvec3& point : axis.line.points)
                _height = std::max(_height, point.z);
        selectAxes();
    }

    AxesSkeleton make() {
        _tree.skeleton.ringsPerBranch = _detail.ringsPerBranch;
        _tree.skeleton.joined = true;
        addAxis(0, -1, 1.0f);
        std::stable_sort(_tree.skeleton.shoots.begin(), _tree.skeleton.shoots.end(),
                         [](const Shoot& a, const Shoot& b) { return a.unit < b.unit; });
        for (std::size_t i = 0; i < _axes.size(); ++i)
            _tree.pieces += hasUnits(i) || _isShoot[i] ? _axes[i].pieces : 0;
        return std::move(_tree);
    }

private:
    /// Selects the axes that become units, those to the top and then the thickest, and those that become
    /// shoots.
    void selectAxes() {
        for (const std::size_t i : axesToTop())
            if (!cutIntoUnits(i))
                break;
        std::size_t shoots = 0;
        bool isFull = false;
        for (const auto& [thickness, i] : thickestFirst()) {
            if (hasUnits(i) || _axes[i].line.length() < minBranchLength * _height)
                continue;
            const auto parent = static_cast<std::size_t>(_axes[i].parent);
            isFull = isFull || thickness < _detail.minRadius;
            if (!isFull && hasUnits(parent) && cutIntoUnits(i))
                continue;
            isFull = isFull || hasUnits(parent);
            if ((hasUnits(parent) || _isShoot[parent]) && shoots < _detail.maxShoots) {
                _isShoot[i] = true;
                ++shoots;
            }
        }
        findBranches();
    }

    /// @return false if there would be too many units.
    bool cutIntoUnits(std::size_t axis) {
        std::vector<double> cuts = computeCuts(_axes[axis], 0.125 * _height);
        if (_units > 0 && _units + cuts.size() - 1 > _detail.maxUnits)
            return false;
        _units += cuts.size() - 1;
        _cuts[axis] = std::move(cuts);
        return true;
    }

    /// Thickness and index of all axes. None is thicker than its parent, and so none precedes it.
    std::vector<std::pair<double, std::size_t>> thickestFirst() const {
        std::vector<std::pair<double, std::size_t>> order;
        for (const WoodAxis& axis : _axes) {
            order.emplace_back(axis.radii.front(), order.size());
            if (double& thickness = order.back().first; axis.parent >= 0)
                thickness = std::min(thickness, order[static_cast<std::size_t>(axis.parent)].first);
        }
        std::stable_sort(order.begin(), order.end(),
                         [](const auto& a, const auto& b) { return a.first > b.first; });
        return order;
    }

    void findBranches() {
        for (std::size_t i = 1; i < _axes.size(); ++i)
            if (hasUnits(i) || _isShoot[i])
                _branches[static_cast<std::size_t>(_axes[i].parent)].push_back(i);
        for (std::vector<std::size_t>& branches : _branches)
            std::sort(branches.begin(), branches.end(), [&](std::size_t a, std::size_t b) {
                return std::make_pair(_axes[a].attach, a) < std::make_pair(_axes[b].attach, b);
            });
    }

    /// The axes on the path from the trunk to the highest point.
    std::vector<std::size_t> axesToTop() const {
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

    bool hasUnits(std::size_t axis) const { return !_cuts[axis].empty(); }

    /// Radii at the cuts of an axis, which keep the volume of its cylinders. @param thickest upper limit.
    std::vector<double> radiiOf(const WoodAxis& axis, const std::vector<double>& cuts,
                                double thickest) const {
        std::vector<double> radii = fittedRadii(axis, cuts);
        double volume = 0.0;
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            const double arc = cuts[i + 1] - cuts[i],
                         chord = glm::distance(axis.line.at(cuts[i]), axis.line.at(cuts[i + 1]));
            volume += frustumVolume(0.5 * (arc + chord), radii[i], radii[i + 1]);
        }
        const double factor = std::sqrt(axis.volume / volume);
        for (double& radius : radii)
            radius = glm::clamp(factor * radius, 1e-5 * _height, thickest);
        return radii;
    }

    /// Adds the units of an axis, each followed by its branches. @param attach position on the unit `parent`.
    void addAxis(std::size_t index, int parent, float attach) {
        const WoodAxis& axis = _axes[index];
        const std::vector<double>& cuts = _cuts[index];
        const double thickest = parent < 0 ? axis.radii.front() * 2.0 : radiusAt(parent, attach);
        const std::vector<double> radii = radiiOf(axis, cuts, thickest);
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
            if (axis.leafy)
                _tree.skeleton.leafyUnits.push_back(leafyPart(axis, from, to));
            const bool isLast = i + 2 == cuts.size();
            for (; branch != _branches[index].end() && (isLast || _axes[*branch].attach <= to); ++branch) {
                const double t = (_axes[*branch].attach - from) / (to - from);
                const auto place = static_cast<float>(glm::clamp(t, 0.02, 1.0));
                if (_isShoot[*branch])
                    addShoots({*branch, pointAt(parent, place), radiusAt(parent, place)}, parent);
                else
                    addAxis(*branch, parent, place);
            }
        }
    }

    /// Start of a shoot. `thickest` is the radius of its parent there.
    struct ShootStart {
        std::size_t axis;
        glm::vec3 base;
        double thickest;
    };

    /// Adds a shoot of a unit and all its branches.
    void addShoots(const ShootStart& first, int unit) {
        std::vector<ShootStart> pending{first};
        while (!pending.empty()) {
            const ShootStart start = pending.back();
            pending.pop_back();
            const WoodAxis& axis = _axes[start.axis];
            const double length = axis.line.length();
            const std::vector<double> radii = radiiOf(axis, {0.0, length}, start.thickest);
            addShoot(axis, start.base, radii, unit);
            for (const std::size_t branch : _branches[start.axis]) {
                const double along = _axes[branch].attach;
                pending.push_back({branch, glm::vec3(axis.line.at(along)),
                                   glm::mix(radii.front(), radii.back(), along / length)});
            }
        }
    }

    /// @param radii at its base and its tip.
    void addShoot(const WoodAxis& axis, const glm::vec3& base, const std::vector<double>& radii, int unit) {
        std::vector<glm::vec3>& points = _tree.skeleton.shootPoints;
        Shoot shoot;
        shoot.unit = unit;
        shoot.level = axis.order;
        shoot.baseRadius = static_cast<float>(radii.front());
        shoot.tipRadius = static_cast<float>(radii.back());
        if (axis.leafy)
            shoot.leafy = leafyPart(axis, 0.0, axis.line.length());
        shoot.first = points.size();
        points.push_back(base);
        const std::vector<glm::dvec3>& line = axis.line.points;
        for (std::size_t i = 1; i + 1 < line.size(); ++i)
            if (isBend(glm::dvec3(points.back()), line[i], line[i + 1], shootTolerance * radii.front()))
                points.emplace_back(line[i]);
        points.emplace_back(line.back());
        shoot.count = points.size() - shoot.first;
        _tree.skeleton.shoots.push_back(shoot);
    }

    /// The leafy part of an axis between two arc lengths, measured from the first.
    static BranchPart leafyPart(const WoodAxis& axis, double from, double to) {
        return {static_cast<float>(std::max(axis.leafy->first - from, 0.0)),
                static_cast<float>(std::min(axis.leafy->second, to) - from)};
    }

    /// Whether a point is farther than `off` from the line between its neighbours.
    static bool isBend(const glm::dvec3& before, const glm::dvec3& point, const glm::dvec3& after,
                       double off) {
        const glm::dvec3 along = after - before, from = point - before;
        const double square = glm::dot(along, along);
        const double part = square > 0.0 ? glm::dot(from, along) / square : 0.0;
        return !(glm::distance(from, part * along) <= off);
    }

    /// Appends a unit and its points, which follow the line. @return its index.
    int add(BranchUnit unit, const WoodLine& line, double from, double to) {
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

    /// Whether points are so close together that the line has no clear direction.
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

    std::vector<WoodAxis> _axes;
    WoodDetail _detail;
    std::vector<std::vector<std::size_t>> _branches; ///< Units and shoots that spring from an axis, upward.
    std::vector<std::vector<double>> _cuts;          ///< Per axis; empty for a shoot or a pruned branch.
    std::vector<bool> _isShoot;                      ///< Per axis.
    std::size_t _units = 0;                          ///< Number of units of all axes.
    double _height = 0.0;
    AxesSkeleton _tree;
};

} // namespace

AxesSkeleton makeSkeleton(std::vector<WoodAxis> axes, const WoodDetail& detail) {
    return SkeletonMaker(std::move(axes), detail).make();
}

} // namespace osgTreeWind
