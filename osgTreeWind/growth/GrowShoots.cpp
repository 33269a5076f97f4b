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

/// A bud grows when it has been allotted this share of an internode.
constexpr float shortestShoot = 0.6f;
/// Smallest pull of limbs upwards in the open and in a closed wood, 1/m.
constexpr float openLimbRise = 0.15f, forestLimbRise = 0.15f;
/// Bends of limbs in a closed wood over those in the open.
constexpr float forestWander = 0.5f;
/// Angle of a side shoot that takes over from a dead end, and of its partner in a fork, over that of others.
constexpr float takingOver = 0.55f, partner = 0.95f;

/// Grows the shoots of one tree in one year.
class ShootGrowth {
public:
    ShootGrowth(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot)
        : _tree(tree), _habit(tree.habit), _light(light), _foot(foot) {}

    void grow() {
        const std::size_t buds = _tree.buds.size(); // Those that grow now add others.
        for (std::size_t b = 0; b < buds; ++b) {
            Bud bud = _tree.buds[b];
            bud.store += yearlyLength(_tree, bud);
            if (bud.store < shortestShoot * _habit.internode[rankOf(bud)]) {
                ++bud.resting;
                bud.spent = !bud.terminal && static_cast<float>(bud.resting) > _habit.budLife;
                _tree.buds[b] = bud;
            } else {
                _tree.buds[b].spent = true;
                growShoot(bud);
            }
        }
    }

private:
    std::size_t rankOf(const Bud& bud) { return TreeState::rank(_tree.axisOf(bud).order); }

    /// The shoot of one bud, of one or several metamers, with its side buds and a new end.
    void growShoot(Bud bud) {
        const int count =
            std::max(1, static_cast<int>(std::lround(bud.store / _habit.internode[rankOf(bud)])));
        const float length = bud.store / static_cast<float>(count);
        if (!bud.terminal)
            beginAxis(_tree.axisOf(bud));
        bool ended = false;
        for (int i = 1; i <= count; ++i) {
            addMetamer(bud, length);
            ended = i == count && endsHere(bud);
            if (!ended)
                addSideBuds(_tree, bud, static_cast<float>(i) / static_cast<float>(count), i == count);
        }
        if (ended)
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
        axis.side = _tree.random.uniform() < 0.5f ? 1 : -1;
    }

    /// One more metamer; the bud moves to its node.
    void addMetamer(Bud& bud, float length) {
        const Metamer& from = _tree.metamerOf(bud);
        Metamer metamer;
        metamer.heading = turned(bud, length);
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

    /// Where a growing end turns to within `length`: up or down, to the horizontal, to the light, and at
    /// random.
    glm::vec3 turned(const Bud& bud, float length) {
        ShootAxis& axis = _tree.axisOf(bud);
        const std::size_t rank = TreeState::rank(axis.order);
        const glm::vec3 before = bud.heading, level = directionOr({before.x, before.y, 0.0f}, before);
        const float x = scatter(_tree.random), y = scatter(_tree.random), z = scatter(_tree.random);
        axis.bending = 0.6f * axis.bending + glm::vec3(x, y, z);
        const float limbRise = glm::mix(forestLimbRise, openLimbRise, _tree.openness());
        const float rise = axis.leading ? std::max(_habit.rise[rank], limbRise) : _habit.rise[rank];
        const glm::vec3 ahead = _foot + _tree.metamerOf(bud).position + length * before;
        const glm::vec3 upwards = axis.order == 0 ? _tree.upright(ahead.z - _foot.z) : up;
        glm::vec3 pull = rise * upwards + _habit.levelling[rank] * (level - before) +
                         _habit.lightSeeking[rank] * _light.towardsLight(ahead);
        if (axis.order == 0) // A leader nods to one side.
            pull += _habit.hang[0] * directionOr({axis.bending.x, axis.bending.y, 0.0f}, level);
        const float wander =
            _habit.wander[rank] * (axis.leading ? glm::mix(forestWander, 1.0f, _tree.openness()) : 1.0f);
        glm::vec3 heading = before + length * pull + std::sqrt(length) * wander * axis.bending;
        if (axis.order > 0 && _habit.zigzag > 0.0f) {
            const glm::vec3 left = directionOr(glm::cross(up, heading), perpendicular(before));
            heading += static_cast<float>(axis.side) * _habit.zigzag * left;
            axis.side = -axis.side;
        }
        return directionOr(heading, before);
    }

    /// The trunk may dissolve, and any end may die. @return whether one of them happened.
    bool endsHere(const Bud& bud) {
        const int order = _tree.axisOf(bud).order;
        if (order == 0 && trunkDissolves(_tree)) {
            dissolveTrunk(_tree, bud);
            return true;
        }
        if (_tree.random.uniform() >= _habit.forking[TreeState::rank(order)])
            return false;
        replaceEnd(bud);
        return true;
    }

    /// A side bud takes over from a dead end, which makes a bend; or both of a pair, which makes a fork.
    void replaceEnd(const Bud& dead) {
        const ShootAxis axis = _tree.axisOf(dead);
        const bool fork = axis.order > 0 && (axis.leading || _habit.budsPerNode >= 2);
        BudPlace place{dead.node, dead.heading, axis.order, axis.phase + _habit.divergence};
        const float angle = _habit.branchAngle[TreeState::rank(axis.order)];
        place.angle = takingOver * angle * (1.0f + 0.2f * scatter(_tree.random));
        Bud& next = addSideBud(_tree, place, axis.order);
        _tree.axes.pop_back(); // The axis itself goes on.
        next.axis = dead.axis;
        next.terminal = true;
        _tree.axisOf(next).phase += _habit.divergence;
        if (!fork)
            return;
        place.azimuth += glm::pi<float>();
        place.angle = partner * angle * (1.0f + 0.2f * scatter(_tree.random));
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
