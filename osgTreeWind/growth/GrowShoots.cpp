// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowShoots.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// Of a vigorous shoot over a usual one.
constexpr float strongest = 1.25f;
/// The least of what a leader grows, whatever its light.
constexpr float leaderLeast = 0.8f;
/// Yearly shoot of a limb into which the trunk has dissolved, over that of the trunk.
constexpr float limbShoot = 0.8f;
/// Share of its vigour that a shoot at the outside of the crown lacks, of a habit with all rounding.
constexpr float slowest = 0.8f;
/// Height at which a dome is widest over that of the tree.
constexpr float domeMiddle = 0.4f;
/// Height of its top, likewise: the tree comes near it and not quite there.
constexpr float domeTop = 1.06f;
/// Height of the lowest bough that becomes a limb over that of the trunk.
constexpr float youngBoughs = 0.65f;
/// Height at which it dissolves in a closed wood.
constexpr float forestTrunk = 0.68f;
/// From limb to limb.
constexpr float goldenAngle = 2.399963f;
/// The least by which limbs turn up, 1/m.
constexpr float limbRise = 0.15f;
/// Angle from an axis that has lost its end to what takes over, over that of side shoots.
constexpr float takingOver = 0.45f;

/// Grows the shoots of one tree in one year.
class ShootGrowth {
public:
    ShootGrowth(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot)
        : _tree(tree), _habit(tree.habit), _light(light), _foot(foot) {}

    void grow() {
        const std::size_t buds = _tree.buds.size();
        for (std::size_t b = 0; b < buds; ++b) {
            Bud bud = _tree.buds[b];
            bud.store += yearlyLength(bud);
            const float internode = _habit.internode[rankOf(bud)];
            if (bud.store < 0.6f * internode) {
                ++bud.resting;
                bud.spent = !bud.terminal && static_cast<float>(bud.resting) > _habit.budLife;
                _tree.buds[b] = bud;
                continue;
            }
            _tree.buds[b].spent = true;
            growShoot(bud);
        }
    }

private:
    Axis& axisOf(const Bud& bud) { return _tree.axes[static_cast<std::size_t>(bud.axis)]; }
    std::size_t rankOf(const Bud& bud) { return TreeState::rank(axisOf(bud).order); }

    /// How much a bud grows in this year, metres.
    float yearlyLength(const Bud& bud) {
        const Axis& axis = axisOf(bud);
        const std::size_t rank = rankOf(bud);
        float vigour = std::min(bud.share, strongest);
        if (axis.order == 0)
            vigour = std::max(vigour, leaderLeast);
        const glm::vec3& place = _tree.metamers[static_cast<std::size_t>(bud.node)].position;
        vigour *= std::max(1.0f - slowest * _habit.rounding * exposure(place), axis.leading ? 0.12f : 0.0f);
        if (!axis.leading)
            vigour *= 1.0f / (1.0f + static_cast<float>(_tree.year - axis.born) / _habit.halfVigour[rank]);
        if (axis.order == 1 && !axis.leading)
            vigour *= spread();
        if (axis.order > 0)
            vigour *= room(place);
        const float shoot =
            axis.leading && axis.order > 0 ? limbShoot * _habit.annualShoot[0] : _habit.annualShoot[rank];
        return vigour * axis.luck * shoot * (0.85f + 0.3f * _tree.random.uniform());
    }

    /// Half the width that the crown is to have at this height.
    float wantedReach() const {
        return 0.5f * _tree.goal.crownWidth * std::min(0.3f + 0.8f * _tree.grown(), 1.0f);
    }
    /// 0 in the middle of the dome that the crown is to fill, 1 at its top and sides, where wind and drought
    /// slow shoots, and more beyond.
    float exposure(const glm::vec3& place) const {
        const float x =
            (place.x * place.x + place.y * place.y) / (0.25f * _tree.goal.crownWidth * _tree.goal.crownWidth);
        const float z = std::max(place.z / _tree.goal.height - domeMiddle, 0.0f) / (domeTop - domeMiddle);
        const float outside = x + z * z;
        return std::min(outside * outside, 1.0f / slowest);
    }
    /// Factor on side shoots: more where the crown is too narrow.
    float spread() const {
        return _tree.spread * glm::clamp(wantedReach() / std::max(_tree.reach, 0.2f), 0.6f, 1.6f);
    }
    /// Shoots that have left the crown far behind stop: wind and drought take them.
    float room(const glm::vec3& place) const {
        const float reach = std::sqrt(place.x * place.x + place.y * place.y) / wantedReach();
        return glm::clamp((1.25f - reach) / 0.4f, 0.0f, 1.0f);
    }

    void growShoot(Bud bud) {
        const std::size_t rank = rankOf(bud);
        const int count = std::max(1, static_cast<int>(bud.store / _habit.internode[rank] + 0.5f));
        const float length = bud.store / static_cast<float>(count);
        if (!bud.terminal) {
            Axis& axis = axisOf(bud);
            axis.born = _tree.year;
            axis.phase = _habit.flat[rank] >= 0.5f ? 0.4f * _tree.random.symmetric()
                                                   : glm::pi<float>() * _tree.random.symmetric();
            axis.side = _tree.random.uniform() < 0.5f ? 1 : -1;
        }
        for (int i = 0; i < count; ++i) {
            addMetamer(bud, length);
            const bool last = i + 1 == count;
            const float along = (static_cast<float>(i) + 1.0f) / static_cast<float>(count);
            if (!last || !divide(bud))
                addSideBuds(bud, along, last);
            else
                return;
        }
        bud.terminal = true;
        bud.store = 0.0f;
        bud.resting = 0;
        bud.weight = 1.0f;
        bud.spent = false;
        _tree.buds.push_back(bud);
    }

    /// One more metamer at the end of a shoot; the bud moves to its node.
    void addMetamer(Bud& bud, float length) {
        Axis& axis = axisOf(bud);
        const std::size_t rank = rankOf(bud);
        const Metamer& from = _tree.metamers[static_cast<std::size_t>(bud.node)];
        const glm::vec3 ahead = from.position + length * bud.heading;
        glm::vec3 heading = bud.heading;
        const glm::vec3 level = directionOr({heading.x, heading.y, 0.0f}, heading);
        const float bendings = std::sqrt(length) * _habit.wander[rank];
        axis.bending = 0.6f * axis.bending + glm::vec3(random(), random(), random());
        const float rise = axis.leading ? std::max(_habit.rise[rank], limbRise) : _habit.rise[rank];
        heading += length * (rise * up + _habit.levelling[rank] * (level - heading) +
                             _habit.lightSeeking[rank] * _light.towardsLight(_foot + ahead)) +
                   bendings * axis.bending;
        if (axis.order == 0)
            heading += length * _habit.hang[0] * directionOr({axis.bending.x, axis.bending.y, 0.0f}, level);
        if (axis.order > 0 && _habit.zigzag > 0.0f) {
            heading += static_cast<float>(axis.side) * _habit.zigzag * leftOf(heading);
            axis.side = -axis.side;
        }
        heading = directionOr(heading, bud.heading);
        Metamer metamer;
        metamer.heading = heading;
        metamer.length = length;
        metamer.position = from.position + length * heading;
        metamer.parent = bud.node;
        metamer.axis = bud.axis;
        metamer.order = axis.order;
        metamer.born = _tree.year;
        bud.node = static_cast<int>(_tree.metamers.size());
        bud.heading = heading;
        _tree.metamers.push_back(metamer);
    }

    /// Side buds of the node where `bud` is. @param along of the year's shoot, up to 1 at its end.
    void addSideBuds(const Bud& bud, float along, bool last) {
        const int order = axisOf(bud).order;
        if (static_cast<float>(order) >= _habit.deepest)
            return;
        const bool whorls = _habit.whorl > 0.0f;
        auto count = static_cast<int>(_habit.budsPerNode);
        float weight = glm::mix(1.0f, along * along, _habit.acrotony);
        if (whorls && order == 0 && last)
            count = static_cast<int>(_habit.whorl + 0.5f + 0.8f * _tree.random.symmetric());
        else if (whorls)
            weight = last ? 1.0f : _habit.betweenWhorls;
        if (whorls && order == 0 && !last)
            count = std::max(count, static_cast<int>(0.5f * _habit.whorl + 0.5f));
        if (weight <= 0.0f)
            return;
        const std::size_t rank = TreeState::rank(order);
        axisOf(bud).phase += _habit.divergence;
        for (int i = 0; i < count; ++i) {
            const float scatter = (whorls && order == 0 ? 0.35f : 0.12f) * random();
            const float azimuth = axisOf(bud).phase + scatter +
                                  glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(count);
            addSideBud(bud, azimuth, _habit.branchAngle[rank] * (1.0f + 0.15f * random()), order + 1, weight);
        }
    }

    /// The end of an axis may die, and what is beside it takes over. @return whether it did.
    bool divide(const Bud& bud) {
        const Axis axis = axisOf(bud);
        const std::size_t rank = rankOf(bud);
        if (axis.order == 0 && dissolves()) {
            dissolve(bud);
            return true;
        }
        if (_tree.random.uniform() >= _habit.forking[rank])
            return false;
        const int pair = axis.leading || _habit.budsPerNode >= 2.0f ? 2 : 1;
        const float azimuth = axis.phase + _habit.divergence;
        for (int i = 0; i < pair; ++i) {
            addSideBud(bud, azimuth + glm::pi<float>() * static_cast<float>(i),
                       takingOver * _habit.branchAngle[rank] * (1.0f + 0.2f * random()),
                       i > 0 ? std::max(axis.order, 1) : axis.order, 1.0f);
            Axis& heir = _tree.axes.back();
            heir.leading = axis.leading;
            heir.born = axis.born;
            if (i > 0)
                continue;
            _tree.axes.pop_back(); // The axis goes on, with a bend.
            Bud& next = _tree.buds.back();
            next.axis = bud.axis;
            next.terminal = true;
            axisOf(next).phase += _habit.divergence;
        }
        return true;
    }

    /// Whether the trunk ends here: where a tree stands free at the height of its habit, in a wood later.
    bool dissolves() const {
        const float share = _tree.height / _tree.goal.height;
        if (_habit.trunkTop >= 1.0f || share < _habit.trunkTop)
            return false;
        const float out = 1.5f * _tree.reach + _light.cell();
        float light = 0.0f;
        for (const glm::vec3& side :
             {glm::vec3(out, 0, 0), glm::vec3(-out, 0, 0), glm::vec3(0, out, 0), glm::vec3(0, -out, 0)})
            light += 0.25f * _light.light(_foot + side + 0.75f * _tree.height * up);
        return share > glm::mix(std::max(_habit.trunkTop, forestTrunk), _habit.trunkTop,
                                glm::smoothstep(0.3f, 0.75f, light));
    }

    /// The trunk ends in limbs, which spring from its last nodes and aim at the crown's width, the lower the
    /// wider.
    void dissolve(const Bud& bud) {
        const auto limbs = static_cast<int>(_habit.limbs);
        float azimuth = glm::pi<float>() * _tree.random.symmetric();
        const float narrow = glm::clamp(std::sqrt(_tree.spread), 0.6f, 1.2f);
        Bud at = bud;
        for (int i = 0; i < limbs; ++i) {
            const Metamer& node = _tree.metamers[static_cast<std::size_t>(at.node)];
            at.heading = node.heading;
            const float above = std::max(_tree.goal.height - node.position.z, 0.5f);
            const float aim = angleOf(0.5f * _tree.goal.crownWidth / above);
            const float wide = 0.45f + 0.55f * static_cast<float>(i) / static_cast<float>(limbs - 1);
            addSideBud(at, azimuth, aim * narrow * (wide + 0.15f * random()), 1, 1.0f);
            _tree.axes.back().leading = true;
            azimuth += goldenAngle + 0.4f * random();
            if (node.parent > 0 && (i > 0 || limbs == 2))
                at.node = node.parent;
        }
        promoteBoughs();
    }

    /// The youngest boughs become limbs too.
    void promoteBoughs() {
        const float from = youngBoughs * _tree.height;
        for (const Metamer& metamer : _tree.metamers)
            if (metamer.order == 1 && metamer.died < 0 && metamer.position.z > from)
                _tree.axes[static_cast<std::size_t>(metamer.axis)].leading = true;
        for (const Bud& bud : _tree.buds)
            if (_tree.metamers[static_cast<std::size_t>(bud.node)].order == 0 && !bud.terminal &&
                _tree.metamers[static_cast<std::size_t>(bud.node)].position.z > from)
                _tree.axes[static_cast<std::size_t>(bud.axis)].leading = true;
    }

    void addSideBud(const Bud& at, float azimuth, float angle, int order, float weight) {
        const std::size_t rank = rankOf(at);
        const glm::vec3 left = leftOf(at.heading), above = glm::cross(at.heading, left);
        const float flat = _habit.flat[rank];
        const glm::vec3 aside =
            directionOr(cosine(azimuth) * left + (1.0f - flat) * sine(azimuth) * above, left);
        Bud bud;
        bud.node = at.node;
        bud.heading = directionOr(cosine(angle) * at.heading + sine(angle) * aside, at.heading);
        bud.axis = static_cast<int>(_tree.axes.size());
        bud.weight = weight;
        Axis axis;
        axis.luck = 1.0f + 0.3f * random();
        axis.order = order;
        axis.born = _tree.year;
        _tree.axes.push_back(axis);
        _tree.buds.push_back(bud);
    }

    static glm::vec3 leftOf(const glm::vec3& heading) {
        return directionOr(glm::cross(up, heading), perpendicular(heading));
    }
    /// With that tangent.
    static float angleOf(float tangent) {
        return static_cast<float>(std::atan(static_cast<double>(tangent)));
    }
    /// From about -1 to 1, mostly near 0.
    float random() { return 0.5f * (_tree.random.symmetric() + _tree.random.symmetric()); }

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
