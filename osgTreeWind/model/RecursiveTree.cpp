// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/RecursiveTree.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/model/TreeKeys.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <utility>

namespace osgTreeWind {
namespace {

/// Upper limit of a branch's length over its parent's, with jitter.
constexpr float maxLengthRatio = 1.5f;

/// The direction at `inclination` from `axis`, at `azimuth` from the side nearest to +x.
glm::vec3 inclined(const glm::vec3& axis, float inclination, float azimuth) {
    const glm::vec3 e1 = perpendicular(axis);
    const glm::vec3 e2 = glm::cross(axis, e1);
    return math::cos(inclination) * axis +
           math::sin(inclination) * (math::cos(azimuth) * e1 + math::sin(azimuth) * e2);
}

float trunkLength(const RecursiveTreeParameters& p) {
    return p.length * static_cast<float>(p.trunkUnits);
}

/// An upper bound of the distance of any point from the root, metres.
float maxReach(const RecursiveTreeParameters& p) {
    const float ratio = std::min(p.lengthRatio * (1.0f + p.jitter), maxLengthRatio);
    float branch = trunkLength(p) *
                   std::min(p.boughLength * std::max(p.crownTaper, 1.0f) * (1.0f + p.jitter), maxLengthRatio);
    float reach = trunkLength(p);
    for (int level = 1; level <= p.levels; ++level, branch *= ratio)
        reach += branch;
    return reach;
}

/// Number of units that these values make.
std::uint64_t countUnits(const RecursiveTreeParameters& p) {
    std::uint64_t count = static_cast<std::uint64_t>(p.trunkUnits);
    std::uint64_t onLevel = static_cast<std::uint64_t>(branchingUnits(p));
    for (int level = 1; level <= p.levels; ++level)
        count += onLevel *= static_cast<std::uint64_t>(p.childrenPerBranch);
    return count;
}

class RecursiveTreeGenerator {
public:
    /// @param parameters must be clamped().
    explicit RecursiveTreeGenerator(const RecursiveTreeParameters& parameters)
        : _p(parameters), _minLength(1e-4f * maxReach(parameters)), _minRadius(1e-5f * maxReach(parameters)),
          _random(parameters.seed) {
        _skeleton.ringsPerBranch = _p.ringsPerBranch;
        _skeleton.units.reserve(countUnits(_p));
        _skeleton.points.reserve(countUnits(_p) * static_cast<std::size_t>(_p.ringsPerBranch));
    }

    Skeleton grow() {
        const float east = _random.symmetric(), north = _random.symmetric();
        _trunkAxis = glm::normalize(up + 0.15f * _p.jitter * glm::vec3(east, north, 0.0f));
        BranchUnit ground;
        ground.tipRadius = atLeastMinRadius(_p.radius);
        growTrunk(0, ground);
        return std::move(_skeleton);
    }

private:
    /// Thinner wood would be lost in the rounding of the coordinates.
    float atLeastMinRadius(float radius) const { return std::max(radius, _minRadius); }

    void growTrunk(int index, const BranchUnit& below) {
        const float height = static_cast<float>(index + 1) / static_cast<float>(_p.trunkUnits);
        BranchUnit unit;
        unit.base = below.tip;
        unit.tip = unit.base + _p.length * _trunkAxis;
        unit.baseRadius = below.tipRadius;
        unit.tipRadius = atLeastMinRadius(_p.radius * glm::mix(1.0f, _p.taper, height));
        unit.parent = index == 0 ? -1 : _trunkTop;
        _trunkTop = addUnit(unit);

        const int bare = _p.trunkUnits - branchingUnits(_p);
        if (index >= bare) {
            const float inCrown =
                static_cast<float>(index - bare) / static_cast<float>(std::max(_p.trunkUnits - 1 - bare, 1));
            growBranches(_trunkTop, trunkLength(_p), _p.boughLength * glm::mix(1.0f, _p.crownTaper, inCrown));
        }
        if (index + 1 < _p.trunkUnits)
            growTrunk(index + 1, unit);
    }

    /// @param ratio length of the branches over `parentLength`.
    void growBranches(int parentIndex, float parentLength, float ratio) {
        const BranchUnit parent = _skeleton.units[static_cast<std::size_t>(parentIndex)];
        if (parent.level == _p.levels)
            return;
        const int level = parent.level + 1;
        const glm::vec3 axis = glm::normalize(parent.tip - parent.base);
        const float spacing = glm::two_pi<float>() / static_cast<float>(_p.childrenPerBranch);
        const float levelInclination =
            _p.inclination * math::pow(_p.inclinationGrowth, static_cast<float>(level - 1));
        // Successive whorls on a trunk are rotated like successive levels.
        const float turn = _p.twist * static_cast<float>(level == 1 ? ++_whorls : level);
        const bool trunkContinues = level == 1 && _whorls < branchingUnits(_p);

        for (int child = 0; child < _p.childrenPerBranch; ++child) {
            const float azimuth =
                spacing * (static_cast<float>(child) + 0.5f * _p.jitter * _random.symmetric()) + turn;
            const float lean = child == 0 && !trunkContinues ? 1.0f - _p.leader : 1.0f;
            const float inclination =
                std::min(lean * levelInclination * (1.0f + _p.jitter * _random.symmetric()), maxInclination);
            const float jittered = ratio * (1.0f + _p.jitter * _random.symmetric());
            const float length = std::max(parentLength * std::min(jittered, maxLengthRatio), _minLength);
            const glm::vec3 fromVertical = inclined(up, inclination, azimuth);
            const glm::vec3 direction = directionOr(
                glm::mix(fromVertical, inclined(axis, inclination, azimuth), _p.follow), fromVertical);

            BranchUnit unit;
            unit.parent = parentIndex;
            unit.level = level;
            unit.base = parent.tip;
            unit.tip = unit.base + length * direction;
            unit.baseRadius = atLeastMinRadius(parent.tipRadius * _p.radiusRatio);
            unit.tipRadius = atLeastMinRadius(unit.baseRadius * _p.taper);
            growBranches(addUnit(unit), length, _p.lengthRatio);
        }
    }

    /// Appends a unit and its points: a straight line plus two slow waves and some noise. All vanish at both
    /// ends with their slopes, so that rings of successive units coincide.
    int addUnit(const BranchUnit& unit) {
        const glm::vec3 along = unit.tip - unit.base;
        const float length = glm::length(along);
        const glm::vec3 e1 = perpendicular(along / length);
        const glm::vec3 e2 = glm::cross(along / length, e1);
        const glm::vec2 bow{_random.symmetric(), _random.symmetric()};
        const glm::vec2 wave{_random.symmetric(), _random.symmetric()};
        const int last = _p.ringsPerBranch - 1;
        // Limits the slope of rings that are closer together than the reference tree's.
        const float roughness = 0.15f * 15.0f / static_cast<float>(std::max(last, 15));
        for (int i = 0; i <= last; ++i) {
            const float t = static_cast<float>(i) / static_cast<float>(last);
            const glm::vec2 uneven{_random.symmetric(), _random.symmetric()};
            const glm::vec2 offset =
                0.7f * 16.0f * t * t * (1.0f - t) * (1.0f - t) *
                (0.5f * bow + 0.35f * wave * math::sin(glm::two_pi<float>() * t) + roughness * uneven);
            const glm::vec3 point =
                unit.base + t * along + _p.crook * length * (offset.x * e1 + offset.y * e2);
            _skeleton.points.push_back(i == last ? unit.tip : point);
        }
        _skeleton.units.push_back(unit);
        return static_cast<int>(_skeleton.units.size()) - 1;
    }

    const RecursiveTreeParameters _p;
    const float _minLength; ///< Branch length.
    const float _minRadius; ///< Radius.
    Random _random;
    Skeleton _skeleton;
    glm::vec3 _trunkAxis{0.0f, 0.0f, 1.0f};
    int _trunkTop = -1; ///< Index of the last trunk unit.
    int _whorls = 0;    ///< Number of first-level whorls so far.
};

} // namespace

RecursiveTreeParameters clamped(RecursiveTreeParameters p) {
    p = clampedKeys(p);
    p.radius = std::min(p.radius, 0.5f * trunkLength(p));
    while (countUnits(p) * static_cast<std::uint64_t>(p.ringsPerBranch) > maxSkeletonPoints)
        --p.levels;
    return p;
}

int branchingUnits(const RecursiveTreeParameters& p) {
    return p.trunkUnits - std::min(p.bareUnits, p.trunkUnits - 1);
}

Skeleton makeRecursiveTree(const RecursiveTreeParameters& parameters) {
    return RecursiveTreeGenerator(clamped(parameters)).grow();
}

} // namespace osgTreeWind
