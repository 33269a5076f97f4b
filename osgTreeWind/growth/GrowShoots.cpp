// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowShoots.h>

#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/growth/Limbs.h>
#include <osgTreeWind/growth/ShootVigour.h>
#include <osgTreeWind/growth/SideBuds.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// A bud grows as soon as its allotted length is this share of an internode.
constexpr float shortestShoot = 0.6f;
/// Lower limit of the upward pull on limbs in the open and in a closed stand, 1/m.
constexpr float openLimbRise = 0.15f, forestLimbRise = 0.15f;
/// Random bends of limbs in a closed stand / in the open.
constexpr float forestWander = 0.5f;
/// Angle of the side shoot that replaces a dead tip, and of the second one in a fork / the usual angle.
constexpr float replacementAngle = 0.55f, forkAngle = 0.95f;

/// Grows the shoots of one tree in one year.
class ShootGrowth {
public:
    ShootGrowth(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot)
        : _tree(tree), _habit(tree.habit), _light(light), _foot(foot) {}

    void grow() {
        const std::size_t buds = _tree.buds.size(); // Growing shoots append new buds.
        for (std::size_t b = 0; b < buds; ++b) {
            Bud bud = _tree.buds[b];
            bud.storedLength += yearlyLength(_tree, bud);
            if (bud.storedLength < shortestShoot * _habit.internode[rankOf(bud)]) {
                ++bud.restingYears;
                bud.spent = !bud.terminal && static_cast<float>(bud.restingYears) > _habit.budLife;
                _tree.buds[b] = bud;
            } else {
                _tree.buds[b].spent = true;
                growShoot(bud);
            }
        }
    }

private:
    std::size_t rankOf(const Bud& bud) { return TreeState::rank(_tree.axisOf(bud).order); }

    /// Grows the shoot of a bud: one or more metamers with side buds, and a new terminal bud.
    void growShoot(Bud bud) {
        const int count =
            std::max(1, static_cast<int>(std::lround(bud.storedLength / _habit.internode[rankOf(bud)])));
        const float length = bud.storedLength / static_cast<float>(count);
        if (!bud.terminal)
            beginAxis(_tree.axisOf(bud));
        bool ends = false;
        for (int i = 1; i <= count; ++i) {
            addMetamer(bud, length);
            ends = i == count && endAxis(bud);
            if (!ends)
                addSideBuds(_tree, bud, static_cast<float>(i) / static_cast<float>(count), i == count);
        }
        if (ends)
            return;
        Bud end;
        end.node = bud.node;
        end.heading = bud.heading;
        end.terminal = true;
        end.axis = bud.axis;
        _tree.buds.push_back(end);
    }

    void beginAxis(ShootAxis& axis) {
        const bool flat = _habit.flat[TreeState::rank(axis.order)] >= 0.5f;
        axis.born = _tree.year;
        axis.phase = (flat ? 0.4f : glm::pi<float>()) * _tree.random.symmetric();
        axis.zigzagSign = _tree.random.uniform() < 0.5f ? 1 : -1;
    }

    /// Adds a metamer and moves the bud to its node.
    void addMetamer(Bud& bud, float length) {
        const Metamer& from = _tree.metamerOf(bud);
        Metamer metamer;
        metamer.heading = growthDirection(bud, length);
        metamer.length = length;
        metamer.position = from.position + length * metamer.heading;
        metamer.parent = bud.node;
        metamer.axis = bud.axis;
        metamer.order = _tree.axisOf(bud).order;
        metamer.born = _tree.year;
        bud.node = static_cast<int>(_tree.metamers.size());
        bud.heading = metamer.heading;
        _tree.metamers.push_back(metamer);
    }

    /// Direction of the next metamer: the bud's heading, pulled up or down, to the horizontal and to the
    /// light, and bent at random.
    glm::vec3 growthDirection(const Bud& bud, float length) {
        ShootAxis& axis = _tree.axisOf(bud);
        const std::size_t rank = TreeState::rank(axis.order);
        const glm::vec3 before = bud.heading, level = directionOr({before.x, before.y, 0.0f}, before);
        const float x = triangular(_tree.random), y = triangular(_tree.random), z = triangular(_tree.random);
        axis.bend = 0.6f * axis.bend + glm::vec3(x, y, z);
        const float limbRise = glm::mix(forestLimbRise, openLimbRise, _tree.openness());
        const float rise = axis.leading ? std::max(_habit.rise[rank], limbRise) : _habit.rise[rank];
        const glm::vec3 ahead = _foot + _tree.metamerOf(bud).position + length * before;
        const glm::vec3 upwards = axis.order == 0 ? _tree.stemDirection(ahead.z - _foot.z) : up;
        glm::vec3 pull = rise * upwards + _habit.levelling[rank] * (level - before) +
                         _habit.lightSeeking[rank] * _light.lightGradient(ahead);
        if (axis.order == 0) // The leader nods to one side.
            pull += _habit.hang[0] * directionOr({axis.bend.x, axis.bend.y, 0.0f}, level);
        const float wander =
            _habit.wander[rank] * (axis.leading ? glm::mix(forestWander, 1.0f, _tree.openness()) : 1.0f);
        glm::vec3 heading = before + length * pull + std::sqrt(length) * wander * axis.bend;
        if (axis.order > 0 && _habit.zigzag > 0.0f) {
            const glm::vec3 left = directionOr(glm::cross(up, heading), perpendicular(before));
            heading += static_cast<float>(axis.zigzagSign) * _habit.zigzag * left;
            axis.zigzagSign = -axis.zigzagSign;
        }
        return directionOr(heading, before);
    }

    /// Divides the trunk if it is high enough, or replaces a tip that dies by chance.
    /// @return whether it did either: the shoot then gets no terminal bud here.
    bool endAxis(const Bud& bud) {
        const int order = _tree.axisOf(bud).order;
        if (order == 0 && trunkDissolves(_tree)) {
            dissolveTrunk(_tree, bud);
            return true;
        }
        if (_tree.random.uniform() >= _habit.forking[TreeState::rank(order)])
            return false;
        replaceTip(bud);
        return true;
    }

    /// Replaces a dead tip by a side bud, which makes a bend, or by a pair of them, which makes a fork.
    void replaceTip(const Bud& dead) {
        const ShootAxis axis = _tree.axisOf(dead);
        const bool fork = axis.order > 0 && (axis.leading || _habit.budsPerNode >= 2);
        BudPlace place{dead.node, dead.heading, axis.order, axis.phase + _habit.divergence};
        const float angle = _habit.branchAngle[TreeState::rank(axis.order)];
        place.angle = replacementAngle * angle * (1.0f + 0.2f * triangular(_tree.random));
        Bud& next = addSideBud(_tree, place, axis.order);
        _tree.axes.pop_back(); // The bud continues the axis of the dead tip.
        next.axis = dead.axis;
        next.terminal = true;
        _tree.axisOf(next).phase += _habit.divergence;
        if (!fork)
            return;
        place.azimuth += glm::pi<float>();
        place.angle = forkAngle * angle * (1.0f + 0.2f * triangular(_tree.random));
        ShootAxis& other = _tree.axisOf(addSideBud(_tree, place, std::max(axis.order, 1)));
        other.leading = axis.leading;
        other.born = axis.born;
    }

    TreeState& _tree;
    const TreeHabit& _habit;
    const ShadeGrid& _light;
    const glm::vec3 _foot;
};

} // namespace

void growShoots(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot) {
    ShootGrowth(tree, light, foot).grow();
}

} // namespace osgTreeWind
