// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/branchwise/DampedBranches.h>

#include <osgTreeWind/motion/laws/AxisPaces.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

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

/// The branches of one tree while they are worked out.
class Builder {
public:
    Builder(const TreeModel& model, const TreeScale& scale, const Species& species, float leaves)
        : _model(model), _units(model.skeleton.units), _scale(scale), _species(species),
          _bears(makeUnitLoads(model, scale, species, leaves)), _branches(_units.size()),
          _loads(_units.size()) {}

    std::vector<Laws::DampedBranch> build() {
        if (_units.empty())
            return {};
        addDrag();
        addInertia();
        bendTogether();
        return std::move(_branches);
    }

private:
    void addDrag() {
        for (std::size_t i = 0; i < _units.size(); ++i) {
            const ScaledUnit unit(_units[i], _scale);
            const glm::vec3 middle = unit.middle();
            Laws::DampedBranch& p = _branches[i];
            p.direction = unit.direction();
            p.maxAngle = _species.branch.maxAngle;
            p.streamlinedTo = _species.wood.streamlinedTo;
            const float wood = _bears[i].woodDrag, leaves = _bears[i].leafDrag;
            _loads[i].add(wood, leaves, middle.z, unit.dragLever());
            for (int a = _units[i].parent; a >= 0; a = _units[static_cast<std::size_t>(a)].parent) {
                const auto below = static_cast<std::size_t>(a);
                const glm::vec3 base = _scale.axes * _units[below].base;
                const float arm = std::max(glm::dot(middle - base, _branches[below].direction), 0.0f);
                _loads[below].add(wood, leaves, middle.z, arm);
            }
        }
    }

    void addInertia() {
        const std::vector<double> speeds = axisPaces(_model, _scale, _bears);
        for (std::size_t i = 0; i < _units.size(); ++i) {
            Laws::DampedBranch& p = _branches[i];
            const auto speed = static_cast<float>(speeds[i]);
            p.stiffness = _bears[i].stiffness;
            p.inertia = p.stiffness / (speed * speed);
            p.damping = 2.0f * _species.wood.dampingRatio * p.stiffness / speed;
        }
    }

    /// The units of an axis swing together, so that the air meets the speed of all of them.
    void bendTogether() {
        std::vector<std::size_t> first(_units.size());
        std::vector<float> shift(_units.size()); // per axis: of its load, under its load
        for (std::size_t i = 0; i < _units.size(); ++i) {
            first[i] = carriesOn(_units, i) ? first[static_cast<std::size_t>(_units[i].parent)] : i;
            shift[first[i]] += _loads[i].square / _branches[i].stiffness;
        }
        for (std::size_t i = 0; i < _units.size(); ++i) {
            Laws::DampedBranch& p = _branches[i];
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
    const std::vector<UnitLoad> _bears; ///< Each unit by itself.
    std::vector<Laws::DampedBranch> _branches;
    std::vector<Load> _loads; ///< Each with all that it carries.
};

} // namespace

std::vector<Laws::DampedBranch> makeDampedBranches(const TreeModel& model, const TreeScale& scale,
                                                   const Species& species, float leaves) {
    return Builder(model, scale, species, leaves).build();
}

Laws::DampedBranch exaggerated(Laws::DampedBranch branch, float gain) {
    if (!(gain > 0.0f)) {
        branch.drag = 0.0f;
        return branch;
    }
    branch.drag *= gain * gain;
    branch.lever /= gain;
    return branch;
}

} // namespace osgTreeWind
