// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/PalmTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/TreeKeys.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr int palmRings = 8; ///< Points per unit.
constexpr int stemUnits = 5;
constexpr float frondTurn = 2.3999632f; ///< The golden angle.
constexpr float breastHeight = 1.3f;
constexpr float frondTaper = 0.35f;
constexpr float lengthSpread = 0.2f;  ///< Largest random reduction of a frond's length.
constexpr float angleSpread = 0.15f;  ///< Largest random change of its inclination, radians.
constexpr float innerDroop = 0.18f;   ///< Share of the droop in the inner half of a frond.
constexpr float winding = 0.05f;      ///< Crook of a frond.
constexpr float maxStalkRatio = 0.9f; ///< Upper limit of a stalk's radius over that of the stem.

/// Rotates a unit vector down by `angle`, at most to the vertical.
glm::vec3 bentDown(const glm::vec3& heading, float angle) {
    const glm::vec3 across = -up - heading * glm::dot(-up, heading);
    if (heading.z < 0.0f && glm::length(across) <= math::sin(angle))
        return -up;
    return glm::normalize(math::cos(angle) * heading +
                          math::sin(angle) * directionOr(across, perpendicular(heading)));
}

class PalmMaker {
public:
    /// @param parameters must be clamped().
    explicit PalmMaker(const PalmParameters& parameters)
        : _p(parameters), _random(parameters.seed), _stemHeight(parameters.height * parameters.trunk) {
        _skeleton.ringsPerBranch = palmRings;
        _skeleton.joined = true;
        _skeleton.flare = _p.flare;
    }

    Skeleton make() {
        _stem = makeCurve(up, 0.0f, _p.trunkCrook, stemUnits);
        for (glm::vec3& point : _stem)
            point *= _stemHeight;
        const float first = std::min(_p.crownBase / _p.trunk, 0.99f); // along the stem
        int next = 0;
        for (int i = 0; i < stemUnits; ++i) {
            const int unit = addStemUnit(i);
            for (; next < _p.fronds; ++next) {
                const float age = (static_cast<float>(next) + 0.5f) / static_cast<float>(_p.fronds);
                const float along = glm::mix(first, 1.0f, age) * stemUnits - static_cast<float>(i);
                if (along > 1.0f)
                    break;
                addFrond(unit, std::max(along, 1e-3f), age, next);
            }
        }
        return std::move(_skeleton);
    }

private:
    /// Points of a branch of length 1 from the origin that droops and winds.
    std::vector<glm::vec3> makeCurve(glm::vec3 heading, float droop, float crook, int units) {
        const int segments = units * (palmRings - 1);
        const auto count = static_cast<float>(segments);
        const float step = crook * 0.7f / std::sqrt(count);
        std::vector<glm::vec3> points{glm::vec3(0.0f)};
        points.reserve(static_cast<std::size_t>(segments) + 1);
        glm::vec3 turn(0.0f);
        for (int i = 0; i < segments; ++i) {
            const float part = i < segments / 2 ? innerDroop : 1.0f - innerDroop;
            heading = bentDown(heading, 2.0f * part * droop / count);
            points.push_back(points.back() + heading / count);
            const float x = _random.symmetric(), y = _random.symmetric(), z = _random.symmetric();
            turn = 0.6f * turn + step * glm::vec3(x, y, z);
            heading = directionOr(heading + turn, heading);
        }
        return points;
    }

    float stemRadius(float along) const {
        const float atBreast = 1.0f - (1.0f - _p.trunkTaper) * std::min(breastHeight / _stemHeight, 1.0f);
        return 0.5f * _p.trunkDiameter / atBreast * glm::mix(1.0f, _p.trunkTaper, along);
    }

    int addStemUnit(int i) {
        constexpr std::ptrdiff_t segments = palmRings - 1;
        const auto first = _stem.begin() + i * segments;
        BranchUnit unit;
        unit.parent = i == 0 ? -1 : _lastStemUnit;
        unit.base = *first;
        unit.tip = *(first + segments);
        unit.baseRadius = stemRadius(static_cast<float>(i) / stemUnits);
        unit.tipRadius = stemRadius(static_cast<float>(i + 1) / stemUnits);
        _skeleton.points.insert(_skeleton.points.end(), first, first + segments + 1);
        _skeleton.units.push_back(unit);
        return _lastStemUnit = static_cast<int>(_skeleton.units.size()) - 1;
    }

    /// The maximum length of a frond within the crown.
    float maxFrondLength(const glm::vec3& foot, const std::vector<glm::vec3>& points) const {
        const float lowest = std::max(_p.height * _p.crownBase - 0.25f * _p.crownWidth, 0.0f),
                    halfWidth = 0.5f * _p.crownWidth;
        const auto outside = [&](float length) {
            return std::any_of(points.begin(), points.end(), [&](const glm::vec3& point) {
                const glm::vec3 p = foot + length * point;
                return p.z > _p.height || p.z < lowest || std::sqrt(p.x * p.x + p.y * p.y) > halfWidth;
            });
        };
        float inside = 0.0f, beyond = _p.height + _p.crownWidth;
        for (int round = 0; round < 20; ++round) {
            const float middle = 0.5f * (inside + beyond);
            (outside(middle) ? beyond : inside) = middle;
        }
        return inside;
    }

    /// @param along position on the stem's unit, (0, 1]. @param age 0: the oldest frond, 1: the youngest.
    void addFrond(int stemUnit, float along, float age, int index) {
        const BranchUnit stem = _skeleton.units[static_cast<std::size_t>(stemUnit)];
        const float ring = along * static_cast<float>(palmRings - 1);
        const int below = std::min(static_cast<int>(ring), palmRings - 2);
        const auto bearer = static_cast<std::size_t>(stemUnit);
        const glm::vec3 a = _skeleton.point(bearer, below), b = _skeleton.point(bearer, below + 1);
        const glm::vec3 foot = glm::mix(a, b, ring - static_cast<float>(below)), axis = glm::normalize(b - a);
        const float azimuth = frondTurn * static_cast<float>(index) + _start;
        const glm::vec3 side = perpendicular(axis);
        const glm::vec3 aside = math::cos(azimuth) * side + math::sin(azimuth) * glm::cross(axis, side);
        const float inclination =
            glm::mix(_p.inclination, _p.inclinationEnd, age) + angleSpread * _random.symmetric();
        std::vector<glm::vec3> points =
            makeCurve(glm::normalize(math::cos(inclination) * axis + math::sin(inclination) * aside),
                      _p.droop, winding, 1);
        const float length = std::max(
            maxFrondLength(foot, points) * (1.0f - lengthSpread * _random.uniform()), 1e-3f * _p.height);
        for (glm::vec3& point : points)
            point = foot + length * point;
        BranchUnit frond;
        frond.parent = stemUnit;
        frond.level = 1;
        frond.base = points.front();
        frond.tip = points.back();
        frond.baseRadius =
            std::min(_p.frondRadius, maxStalkRatio * glm::mix(stem.baseRadius, stem.tipRadius, along));
        frond.tipRadius = frondTaper * frond.baseRadius;
        frond.attach = along;
        _skeleton.units.push_back(frond);
        _skeleton.points.insert(_skeleton.points.end(), points.begin(), points.end());
    }

    const PalmParameters _p;
    Random _random;
    const float _stemHeight;
    const float _start = _random.uniform() * 6.2831853f; ///< Azimuth of the oldest frond.
    std::vector<glm::vec3> _stem;                        ///< From the ground to the top.
    int _lastStemUnit = -1;
    Skeleton _skeleton;
};

} // namespace

PalmParameters clamped(PalmParameters p) {
    p = clampedKeys(p);
    p.trunk = std::max(p.trunk, p.crownBase);
    p.trunkDiameter = std::min(p.trunkDiameter, 0.5f * p.height * p.trunk);
    p.crownWidth = glm::clamp(p.crownWidth, 0.01f * p.height, 4.0f * p.height);
    return p;
}

Skeleton makePalmTree(const PalmParameters& parameters) {
    return PalmMaker(clamped(parameters)).make();
}

} // namespace osgTreeWind
