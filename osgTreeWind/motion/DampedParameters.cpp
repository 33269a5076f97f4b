// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/DampedParameters.h>

#include <osgTreeWind/motion/SwayModes.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

constexpr float pi = 3.14159265f;
constexpr float airDensity = 1.225f; // kg/m^3, standard atmosphere at sea level

float largestHeight(const Skeleton& skeleton) {
    float height = 0.0f;
    for (const BranchUnit& unit : skeleton.units)
        height = std::max(height, unit.tip.z);
    return height;
}

/// Cross-section of the trunk at breast height (a tenth of a tree below 13 m), m^2.
float trunkSection(const Skeleton& skeleton, const TreeScale& scale) {
    const float height = std::min(1.3f, 0.1f * scale.axes.z * largestHeight(skeleton));
    float radius = 0.0f;
    for (const BranchUnit& unit : skeleton.units) {
        const float base = scale.axes.z * unit.base.z, tip = scale.axes.z * unit.tip.z;
        if (unit.parent < 0 || (unit.level == 0 && height >= base))
            radius = glm::mix(unit.baseRadius, unit.tipRadius,
                              std::clamp((height - base) / std::max(tip - base, 1.0e-6f), 0.0f, 1.0f));
    }
    return pi * radius * radius * scale.radius * scale.radius;
}

/// Share of the tree's leaves on each unit.
std::vector<float> leafShares(const TreeModel& model) {
    const std::vector<BranchUnit>& units = model.skeleton.units;
    std::vector<bool> bears(units.size());
    for (const LeafCluster& cluster : model.leaves)
        bears[static_cast<std::size_t>(cluster.unit)] = true;
    std::vector<float> shares(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        const float section = units[i].baseRadius * units[i].baseRadius;
        shares[i] += section;
        if (units[i].parent >= 0)
            shares[static_cast<std::size_t>(units[i].parent)] -= section;
    }
    float sum = 0.0f;
    for (std::size_t i = 0; i < units.size(); ++i)
        sum += shares[i] = bears[i] ? std::max(shares[i], 0.0f) : 0.0f;
    for (float& share : shares)
        share = sum > 0.0f ? share / sum : 0.0f;
    return shares;
}

/// Outline of the crown seen from the side, taken as a rhombus, m^2.
float crownOutline(const TreeModel& model, const TreeScale& scale) {
    if (model.leaves.empty())
        return 0.0f;
    glm::vec3 low = model.leaves.front().anchor, high = low;
    for (const LeafCluster& cluster : model.leaves) {
        low = glm::min(low, cluster.anchor);
        high = glm::max(high, cluster.anchor);
    }
    const glm::vec3 size = scale.axes * (high - low);
    return 0.25f * (size.x + size.y) * size.z;
}

/// Where the drag on a branch acts, over its length: 3/8 for no taper, 0.263 at half.
float leverShare(float taper) {
    return 0.375f - 0.224f * (1.0f - std::clamp(taper, 0.0f, 1.0f));
}

/// Drag of a unit and all that it carries, from its base.
struct Load {
    float area = 0.0f;   ///< Sum of CdA, m^2.
    float crown = 0.0f;  ///< The part of it that streamlines.
    float height = 0.0f; ///< Sum of CdA times height.
    float moment = 0.0f; ///< Sum of CdA times arm.
    float square = 0.0f; ///< Sum of CdA times arm squared.

    void add(float wood, float leaves, float at, float arm) {
        const float both = wood + leaves;
        area += both;
        crown += leaves;
        height += both * at;
        moment += both * arm;
        square += both * arm * arm;
    }
};

/// The parameters of one tree while they are worked out.
class Builder {
public:
    Builder(const TreeModel& model, const TreeScale& scale, const Species& species)
        : _model(model), _units(model.skeleton.units), _scale(scale), _species(species),
          _parameters(_units.size()), _loads(_units.size()) {}

    std::vector<DampedParameters> build() {
        if (_units.empty())
            return {};
        addDrag();
        addStiffness();
        addInertia();
        bendTogether();
        return std::move(_parameters);
    }

private:
    glm::vec3 span(std::size_t i) const { return _scale.axes * (_units[i].tip - _units[i].base); }
    float length(std::size_t i) const { return std::max(glm::length(span(i)), 1.0e-6f); }
    float baseDiameter(std::size_t i) const {
        return std::max(2.0f * _units[i].baseRadius * _scale.radius, 1.0e-6f);
    }
    float tipDiameter(std::size_t i) const {
        return std::max(2.0f * _units[i].tipRadius * _scale.radius, 1.0e-6f);
    }
    bool goesOn(std::size_t i) const { // the axis of its parent
        return _units[i].parent >= 0 && _units[parent(i)].level == _units[i].level;
    }
    std::size_t parent(std::size_t i) const { return static_cast<std::size_t>(_units[i].parent); }

    void addDrag() {
        const WoodParameters& wood = _species.wood;
        const std::vector<float> shares = leafShares(_model);
        const float section = trunkSection(_model.skeleton, _scale);
        const bool known = wood.crownDrag > 0.0f && !_model.leaves.empty();
        const float leafArea = wood.leafArea * section;
        const float crown =
            known ? wood.crownDrag * std::pow(10.0f, -wood.streamlining) * crownOutline(_model, _scale)
                  : wood.leafDrag * leafArea;
        _leafMass.resize(_units.size());
        for (std::size_t i = 0; i < _units.size(); ++i) {
            DampedParameters& p = _parameters[i];
            const glm::vec3 along = span(i), middle = _scale.axes * _units[i].base + 0.5f * along;
            p.direction = glm::length(along) > 0.0f ? glm::normalize(along) : glm::vec3(0.0f, 0.0f, 1.0f);
            p.maxAngle = _species.branch.maxAngle;
            p.streamlinedTo = wood.streamlinedTo;
            _leafMass[i] = wood.leafMass * leafArea * shares[i];
            const float d0 = baseDiameter(i), d1 = tipDiameter(i);
            // A crown is measured with its branches.
            const float own =
                known && _units[i].level > 0 ? 0.0f : wood.woodDrag * 0.5f * (d0 + d1) * length(i);
            const float leaves = crown * shares[i];
            _loads[i].add(own, leaves, middle.z, leverShare(d1 / d0) * length(i));
            for (int a = _units[i].parent; a >= 0; a = _units[static_cast<std::size_t>(a)].parent) {
                const auto below = static_cast<std::size_t>(a);
                const glm::vec3 base = _scale.axes * _units[below].base;
                const float arm = std::max(glm::dot(middle - base, _parameters[below].direction), 0.0f);
                _loads[below].add(own, leaves, middle.z, arm);
            }
        }
    }

    void addStiffness() {
        const double modulus = _species.wood.elasticModulus * std::pow(_species.wood.underBark, 4.0);
        std::vector<float> reach(_units.size());
        for (std::size_t i = _units.size(); i-- > 0;) {
            reach[i] += length(i);
            if (goesOn(i))
                reach[parent(i)] = reach[i];
            _parameters[i].stiffness = static_cast<float>(
                jointStiffness(modulus, baseDiameter(i), tipDiameter(i), length(i), reach[i]));
        }
    }

    void addInertia() {
        const std::vector<double> speeds = swaySpeeds(_model, _scale, _species.wood, _leafMass);
        for (std::size_t i = 0; i < _units.size(); ++i) {
            DampedParameters& p = _parameters[i];
            const auto speed = static_cast<float>(speeds[i]);
            p.inertia = p.stiffness / (speed * speed);
            p.damping = 2.0f * _species.wood.dampingRatio * p.stiffness / speed;
        }
    }

    /// The units of an axis swing together, so that the air meets the speed of all of them.
    void bendTogether() {
        std::vector<std::size_t> first(_units.size());
        std::vector<float> shift(_units.size()); // per axis: of its load, under its load
        for (std::size_t i = 0; i < _units.size(); ++i) {
            first[i] = goesOn(i) ? first[parent(i)] : i;
            shift[first[i]] += _loads[i].square / _parameters[i].stiffness;
        }
        for (std::size_t i = 0; i < _units.size(); ++i) {
            DampedParameters& p = _parameters[i];
            const Load& load = _loads[i];
            p.windHeight = load.area > 0.0f ? load.height / load.area : _scale.axes.z * _units[i].base.z;
            if (!(load.moment > 0.0f))
                continue;
            p.lever = shift[first[i]] * p.stiffness / load.moment;
            p.drag = 0.5f * airDensity * load.moment / p.lever;
            p.streamlining = _species.wood.streamlining * load.crown / load.area;
        }
    }

    const TreeModel& _model;
    const std::vector<BranchUnit>& _units;
    const TreeScale& _scale;
    const Species& _species;
    std::vector<DampedParameters> _parameters;
    std::vector<Load> _loads;
    std::vector<double> _leafMass; ///< kg on each unit.
};

} // namespace

std::vector<DampedParameters> makeDampedParameters(const TreeModel& model, const TreeScale& scale,
                                                   const Species& species) {
    return Builder(model, scale, species).build();
}

DampedParameters exaggerated(DampedParameters parameters, float gain) {
    if (!(gain > 0.0f)) {
        parameters.drag = 0.0f;
        return parameters;
    }
    parameters.drag *= gain * gain;
    parameters.lever /= gain;
    return parameters;
}

} // namespace osgTreeWind
