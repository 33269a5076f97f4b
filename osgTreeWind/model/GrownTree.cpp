// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/GrownTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/CrownOutline.h>
#include <osgTreeWind/model/RecursiveTree.h>
#include <osgTreeWind/model/TreeFields.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {
namespace {

/// A branch where it springs is thinner than what bears it.
constexpr float widestBase = 0.9f;

/// The unit vector `heading` turned up by `angle`, or down, at most until it is vertical.
glm::vec3 risen(const glm::vec3& heading, float angle) {
    const glm::vec3 goal = angle < 0.0f ? -up : up;
    const glm::vec3 across = goal - heading * glm::dot(goal, heading);
    const float left = glm::length(across), turn = std::abs(angle);
    if (glm::dot(goal, heading) > 0.0f && left <= sine(turn))
        return goal;
    return glm::normalize(cosine(turn) * heading + sine(turn) * directionOr(across, perpendicular(heading)));
}

/// A direction at `inclination` from `axis`. @param flat presses it to the left or right of the axis.
glm::vec3 springing(const glm::vec3& axis, float inclination, float azimuth, float flat) {
    const glm::vec3 left = directionOr(glm::cross(up, axis), perpendicular(axis));
    const glm::vec3 above = glm::cross(axis, left);
    const glm::vec3 aside = directionOr(cosine(azimuth) * left + (1.0f - flat) * sine(azimuth) * above,
                                        cosine(azimuth) < 0.0f ? -left : left);
    return glm::normalize(cosine(inclination) * axis + sine(inclination) * aside);
}

/// The trunk or a branch: units in line.
struct Axis {
    int level = 0;
    int parent = -1;     ///< Unit that bears it.
    float attach = 1.0f; ///< Along that unit.
    float place = 0.0f;  ///< Along the axis that bears it, 0 to 1.
    float length = 0.0f, baseRadius = 0.0f, tipRadius = 0.0f;
    std::vector<glm::vec3> points; ///< From base to tip, evenly spaced.
};

class GrownTreeGenerator {
public:
    /// @param parameters within their ranges.
    explicit GrownTreeGenerator(const GrownTreeParameters& parameters)
        : _p(parameters), _shortest(1e-3f * parameters.height), _thinnest(1e-5f * parameters.height),
          _random(parameters.seed) {
        _skeleton.ringsPerBranch = _p.ringsPerBranch;
        _skeleton.joined = true;
        _skeleton.flare = _p.flare;
    }

    Skeleton grow() {
        Axis trunk;
        trunk.length = _p.height * _p.trunk;
        trunk.baseRadius = std::max(_p.radius, _thinnest);
        trunk.tipRadius = std::max(_p.radius * _p.trunkTaper, _thinnest);
        trunk.points = course(up, 0.0f, 0.0f, _p.trunkCrook, _p.trunkUnits);
        for (glm::vec3& point : trunk.points)
            point *= trunk.length;
        add(trunk);
        return std::move(_skeleton);
    }

private:
    const GrownBranches& branches(int level) const {
        return level == 1 ? _p.boughs : level == 2 ? _p.branches : _p.twigs;
    }
    int unitsOf(int level) const { return level == 0 ? _p.trunkUnits : branches(level).units; }

    /// The way of an axis of length 1 from the origin: it turns up or down and winds.
    std::vector<glm::vec3> course(glm::vec3 heading, float rise, float riseOutside, float crook, int units) {
        const int segments = units * (_p.ringsPerBranch - 1);
        const auto count = static_cast<float>(segments);
        const float step = crook * 0.7f / std::sqrt(count);
        std::vector<glm::vec3> points{glm::vec3(0.0f)};
        points.reserve(static_cast<std::size_t>(segments) + 1);
        glm::vec3 winding(0.0f);
        float risenBy = 0.0f;
        for (int i = 0; i < segments; ++i) {
            const float middle = (static_cast<float>(i) + 0.5f) / count;
            const float riseTo =
                2.0f * (std::min(middle, 0.5f) * rise + std::max(middle - 0.5f, 0.0f) * riseOutside);
            heading = risen(heading, glm::clamp(riseTo - risenBy, -2.0f, 2.0f));
            risenBy = riseTo;
            points.push_back(points.back() + heading / count);
            const float x = _random.symmetric(), y = _random.symmetric(), z = _random.symmetric();
            winding = 0.6f * winding + step * glm::vec3(x, y, z);
            heading = directionOr(heading + winding, heading);
        }
        return points;
    }

    /// How far a bough can grow along its way until it reaches the outline of the crown.
    float lengthToOutline(const glm::vec3& base, const std::vector<glm::vec3>& course) const {
        const float depth = _p.height * (1.0f - _p.crownBase);
        const float lowest = std::max(_p.height - depth - 0.25f * _p.crownWidth, 0.0f);
        const auto outside = [&](float length) {
            return std::any_of(course.begin(), course.end(), [&](const glm::vec3& point) {
                const glm::vec3 p = base + length * point;
                const float reach = std::sqrt(p.x * p.x + p.y * p.y);
                return p.z > _p.height || p.z < lowest ||
                       reach > 0.5f * _p.crownWidth * crownWidth(_p.shape, (_p.height - p.z) / depth);
            });
        };
        float inside = 0.0f, beyond = _p.height + _p.crownWidth;
        for (int round = 0; round < 20; ++round) {
            const float middle = 0.5f * (inside + beyond);
            (outside(middle) ? beyond : inside) = middle;
        }
        return inside;
    }

    /// Branches that an axis bears, from its base to its tip, not yet on the skeleton.
    std::vector<Axis> branchesOf(const Axis& axis) {
        const int level = axis.level + 1;
        if (level > 3)
            return {};
        const GrownBranches& kind = branches(level);
        const float start = level == 1 ? std::min(_p.crownBase / _p.trunk, 0.99f) : kind.start;
        const float size = level == 1 ? 1.0f : axis.length / _longest[static_cast<std::size_t>(level - 1)];
        const auto count =
            static_cast<int>(std::lround(static_cast<float>(kind.count) * std::min(size, 1.0f)));
        const std::vector<int> strata = shuffled(count);
        std::vector<Axis> children;
        float sum = 0.0f;
        for (int i = 0; i < count; ++i) {
            Axis child;
            child.level = level;
            const bool fork = level == 1 && i >= count - _p.forks;
            const float along = fork ? 1.0f : alongCrown(i, count - (level == 1 ? _p.forks : 0), level);
            child.place = glm::mix(start, 1.0f, along);
            const float azimuth =
                glm::two_pi<float>() *
                (static_cast<float>(strata[static_cast<std::size_t>(i)]) + _random.uniform()) /
                static_cast<float>(count);
            const float usual =
                fork ? _p.forkInclination : glm::mix(kind.inclination, kind.inclinationEnd, along);
            const float inclination = usual + kind.inclinationVariation * _random.symmetric();
            const auto [base, tangent] = at(axis, child.place);
            child.points = course(springing(tangent, inclination, azimuth, kind.flat), kind.rise,
                                  kind.riseOutside, kind.crook, kind.units);
            const float whole =
                level == 1 ? lengthToOutline(base, child.points) : axis.length * (1.0f - 0.6f * child.place);
            child.length =
                std::max(whole * kind.length * (1.0f - kind.lengthVariation * _random.uniform()), _shortest);
            for (glm::vec3& point : child.points)
                point = base + child.length * point;
            sum += power(child.length, 2.0f * kind.power);
            children.push_back(std::move(child));
        }
        const float bearing = radius(axis, level == 1 ? start : 0.0f);
        for (Axis& child : children) {
            const float share = kind.sections * power(child.length, 2.0f * kind.power) / sum;
            child.baseRadius = std::max(
                std::min(bearing * std::sqrt(share), widestBase * radius(axis, child.place)), _thinnest);
            child.tipRadius = std::max(child.baseRadius * kind.taper, _thinnest);
            float& longest = _longest[static_cast<std::size_t>(level)];
            if (level == 1)
                longest = std::max(longest, child.length);
        }
        if (level == 1)
            _longest[2] = _longest[1] * _p.branches.length * (1.0f - 0.6f * _p.branches.start);
        std::stable_sort(children.begin(), children.end(),
                         [](const Axis& a, const Axis& b) { return a.place < b.place; });
        return children;
    }

    /// Where the i-th of so many branches springs, 0 to 1; boughs may stand in whorls.
    float alongCrown(int i, int count, int level) {
        const int whorl = level == 1 ? _p.whorl : 1;
        const int whorls = std::max((count + whorl - 1) / whorl, 1), below = i / whorl;
        const float scatter = whorl > 1 ? 0.4f : 1.0f;
        return (static_cast<float>(below) + 0.5f + 0.5f * scatter * _random.symmetric()) /
               static_cast<float>(whorls);
    }

    /// 0 to count - 1 in any order.
    std::vector<int> shuffled(int count) {
        std::vector<int> order(static_cast<std::size_t>(count));
        for (std::size_t i = 0; i < order.size(); ++i) {
            const auto other = static_cast<std::size_t>(_random.next() % (i + 1));
            order[i] = order[other];
            order[other] = static_cast<int>(i);
        }
        return order;
    }

    static float radius(const Axis& axis, float place) {
        return glm::mix(axis.baseRadius, axis.tipRadius, place);
    }

    /// Point and direction of an axis at `place`, 0 to 1.
    static std::pair<glm::vec3, glm::vec3> at(const Axis& axis, float place) {
        const std::size_t segments = axis.points.size() - 1;
        const float ring = place * static_cast<float>(segments);
        const std::size_t i = std::min(static_cast<std::size_t>(ring), segments - 1);
        const glm::vec3 a = axis.points[i], b = axis.points[i + 1];
        return {glm::mix(a, b, ring - static_cast<float>(i)), glm::normalize(b - a)};
    }

    /// Appends the units of an axis, each followed by what it bears.
    void add(const Axis& axis) {
        std::vector<Axis> children = branchesOf(axis);
        const int units = unitsOf(axis.level);
        const auto segments = static_cast<std::size_t>(_p.ringsPerBranch - 1);
        auto child = children.begin();
        int parent = axis.parent;
        for (int i = 0; i < units; ++i) {
            const float from = static_cast<float>(i) / static_cast<float>(units);
            const float to = static_cast<float>(i + 1) / static_cast<float>(units);
            const auto first =
                axis.points.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(i) * segments);
            const auto last = first + static_cast<std::ptrdiff_t>(segments);
            BranchUnit unit;
            unit.parent = parent;
            unit.level = axis.level;
            unit.base = *first;
            unit.tip = *last;
            unit.baseRadius = radius(axis, from);
            unit.tipRadius = radius(axis, to);
            unit.attach = i == 0 ? axis.attach : 1.0f;
            parent = static_cast<int>(_skeleton.units.size());
            _skeleton.units.push_back(unit);
            _skeleton.points.insert(_skeleton.points.end(), first, last + 1);
            for (; child != children.end() && (child->place <= to || i + 1 == units); ++child) {
                child->parent = parent;
                child->attach = std::clamp((child->place - from) / (to - from), 1e-3f, 1.0f);
                add(*child);
            }
        }
    }

    const GrownTreeParameters _p;
    const float _shortest; ///< Branch length.
    const float _thinnest; ///< Radius.
    Random _random;
    Skeleton _skeleton;
    std::array<float, 4> _longest{}; ///< Branch of each level that bears all its branches.
};

/// No skeleton has more points.
std::uint64_t mostPoints(const GrownTreeParameters& p) {
    const auto number = [](int value) { return static_cast<std::uint64_t>(value); };
    const std::uint64_t boughs = number(p.boughs.count), branches = boughs * number(p.branches.count);
    const std::uint64_t twigs = branches * number(p.twigs.count);
    return number(p.ringsPerBranch) * (number(p.trunkUnits) + boughs * number(p.boughs.units) +
                                       branches * number(p.branches.units) + twigs * number(p.twigs.units));
}

} // namespace

GrownTreeParameters clamped(GrownTreeParameters p) {
    p = clampedFields(p);
    p.radius = std::min(p.radius, 0.25f * p.height);
    p.crownWidth = glm::clamp(p.crownWidth, 0.01f * p.height, 4.0f * p.height);
    while (p.twigs.count > 0 && mostPoints(p) > maxSkeletonPoints)
        --p.twigs.count;
    while (p.branches.count > 0 && mostPoints(p) > maxSkeletonPoints)
        --p.branches.count;
    return p;
}

Skeleton makeGrownTree(const GrownTreeParameters& parameters) {
    return GrownTreeGenerator(clamped(parameters)).grow();
}

} // namespace osgTreeWind
