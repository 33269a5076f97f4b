// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowYear.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/UnitVectors.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

enum class Fate : unsigned char { Lives, Dies, Falls };

/// When a bough dies, the wood that grew after this share of its life breaks off.
constexpr float snapShare = 0.5f;
/// Below this share of the clean stem, branches are browsed or mown.
constexpr float browsingShare = 0.6f;
/// Light that the wood of a branch needs: this share of full light on leaves along all of it.
constexpr float woodUpkeep = 0.04f;

/// Sums over all that a metamer bears: leaf area, leaf area times light, and length of living wood.
struct Foliage {
    float area = 0.0f, light = 0.0f, wood = 0.0f;
};

std::vector<Foliage> sumFoliage(const std::vector<Metamer>& metamers) {
    std::vector<Foliage> foliage(metamers.size());
    for (std::size_t i = metamers.size() - 1; i > 0; --i) {
        foliage[i].area += metamers[i].leafArea;
        foliage[i].light += metamers[i].leafArea * metamers[i].light;
        foliage[i].wood += metamers[i].died < 0 ? metamers[i].length : 0.0f;
        Foliage& parent = foliage[static_cast<std::size_t>(metamers[i].parent)];
        parent.area += foliage[i].area;
        parent.light += foliage[i].light;
        parent.wood += foliage[i].wood;
    }
    return foliage;
}

/// Whether a branch, given by its first metamer, dies this year.
bool branchDies(TreeState& tree, const Metamer& first, const Foliage& foliage) {
    const TreeHabit& habit = tree.habit;
    const int age = tree.year - first.born;
    if (age < 2)
        return false;
    const float clean = habit.cleanStem * tree.goal.height;
    if (age > 4 && first.position.z < browsingShare * clean && tree.height > 0.5f * tree.goal.height)
        return true;
    if (first.order == 1 && age > 8 && tree.random.uniform() < habit.breakage)
        return true;
    if (first.order == 1 && !tree.axisOf(first).leading) {
        if (first.position.z < clean && tree.height > 2.0f * first.position.z + 1.0f && age > 4)
            return true;
    }
    if (age > 4 && foliage.light < woodUpkeep * habit.leafArea * foliage.wood)
        return true;
    return foliage.area <= 0.0f || foliage.light < tree.lightNeed() * foliage.area;
}

std::vector<Fate> decideFates(TreeState& tree) {
    std::vector<Metamer>& metamers = tree.metamers;
    const std::vector<Foliage> foliage = sumFoliage(metamers);
    std::vector<Fate> fates(metamers.size(), Fate::Lives);
    const int deadYears = tree.habit.deadYears;
    for (std::size_t i = 1; i < metamers.size(); ++i) {
        Metamer& metamer = metamers[i];
        const auto parent = static_cast<std::size_t>(metamer.parent);
        const bool first = metamer.axis != metamers[parent].axis;
        if (fates[parent] == Fate::Falls) {
            fates[i] = Fate::Falls;
        } else if (metamer.died >= 0) {
            // The twigs of a dead bough fall first.
            const int stays = metamer.order == 1 ? deadYears : metamer.order == 2 ? deadYears / 2 : 0;
            fates[i] = first && tree.year - metamer.died >= stays ? Fate::Falls : Fate::Dies;
        } else if (fates[parent] == Fate::Dies) {
            const int since = tree.axisOf(metamer).born;
            const bool outer =
                static_cast<float>(metamer.born - since) > snapShare * static_cast<float>(tree.year - since);
            fates[i] = metamer.order > 2 || outer ? Fate::Falls : Fate::Dies;
        } else if (first && branchDies(tree, metamer, foliage[i])) {
            fates[i] = metamer.order == 1 && deadYears > 0 ? Fate::Dies : Fate::Falls;
        }
        if (fates[i] == Fate::Dies && metamer.died < 0)
            metamer.died = tree.year;
    }
    return fates;
}

/// Lets branches die whose leaves get too little light, breaks some, and drops old dead wood. Reads
/// Metamer::light and leafArea. Removes metamers and their buds, which changes the indices of the others.
void shedBranches(TreeState& tree) {
    const std::vector<Fate> fates = decideFates(tree);
    std::vector<int> place(tree.metamers.size(), -1);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < tree.metamers.size(); ++i) {
        if (fates[i] == Fate::Falls)
            continue;
        Metamer metamer = tree.metamers[i];
        if (metamer.parent >= 0)
            metamer.parent = place[static_cast<std::size_t>(metamer.parent)];
        place[i] = static_cast<int>(kept);
        tree.metamers[kept++] = metamer;
    }
    tree.metamers.resize(kept);
    std::size_t buds = 0;
    for (const Bud& bud : tree.buds) {
        if (bud.spent || fates[static_cast<std::size_t>(bud.node)] != Fate::Lives)
            continue;
        tree.buds[buds] = bud;
        tree.buds[buds++].node = place[static_cast<std::size_t>(bud.node)];
    }
    tree.buds.resize(buds);
}

/// Sets the gains of all buds and sums them towards the foot.
void sumGains(TreeState& tree) {
    for (Metamer& metamer : tree.metamers)
        metamer.mainGain = metamer.sideGain = 0.0f;
    const float need = tree.lightNeed();
    for (Bud& bud : tree.buds) {
        bud.gain = bud.weight * std::max(bud.light - need, 0.0f) / (1.0f - need);
        Metamer& metamer = tree.metamerOf(bud);
        (bud.terminal ? metamer.mainGain : metamer.sideGain) += bud.gain;
    }
    for (std::size_t i = tree.metamers.size() - 1; i > 0; --i) {
        const Metamer& metamer = tree.metamers[i];
        Metamer& parent = tree.parentOf(metamer);
        (metamer.axis == parent.axis ? parent.mainGain : parent.sideGain) +=
            metamer.mainGain + metamer.sideGain;
    }
}

/// Distributes a year's growth among the buds. The gains of their light are summed towards the foot, and the
/// sum is divided at each node between the axis and its side shoots (Borchert and Honda 1984). Reads
/// Bud::light; sets Bud::gain and Bud::share. Without apical control a bud's share is its own gain, 0 to 1.
void allotGrowth(TreeState& tree) {
    sumGains(tree);
    std::vector<float> perMain(tree.metamers.size()), perSide(tree.metamers.size());
    for (std::size_t i = 0; i < tree.metamers.size(); ++i) {
        Metamer& metamer = tree.metamers[i];
        if (i == 0) {
            metamer.share = metamer.mainGain + metamer.sideGain;
        } else {
            const auto parent = static_cast<std::size_t>(metamer.parent);
            const bool goesOn = metamer.axis == tree.metamers[parent].axis;
            metamer.share =
                (goesOn ? perMain[parent] : perSide[parent]) * (metamer.mainGain + metamer.sideGain);
        }
        float control = tree.habit.apicalControl[TreeState::rank(metamer.order)];
        if (metamer.order == 0)
            control = glm::mix(control, tree.habit.apicalControlOld, tree.relativeHeight());
        const float sum = control * metamer.mainGain + (1.0f - control) * metamer.sideGain;
        if (sum > 0.0f) {
            perMain[i] = metamer.share * control / sum;
            perSide[i] = metamer.share * (1.0f - control) / sum;
        }
    }
    for (Bud& bud : tree.buds) {
        const auto node = static_cast<std::size_t>(bud.node);
        bud.share = (bud.terminal ? perMain[node] : perSide[node]) * bud.gain;
    }
}

/// Upper limit of a shoot's vigour. A shoot in full light without competitors has 1.
constexpr float maxVigour = 1.25f;
/// Lower limit of the vigour of the trunk's shoot, whatever its light.
constexpr float minTrunkVigour = 0.8f;
/// Lower limit of a limb's factor at the surface of the crown, so that the tree reaches its height.
constexpr float minLimbVigour = 0.12f;
/// Yearly shoot of a limb / of the trunk.
constexpr float limbShoot = 0.8f;
/// Share of its vigour that a shoot loses at the surface of the crown if `rounding` is 1.
constexpr float exposureLoss = 0.8f;
/// Height at which the crown's dome is widest / tree height.
constexpr float domeWidestHeight = 0.4f;
/// Top of the dome / tree height, while the tree grows and when it is mature.
constexpr float growingDomeTop = 1.06f, matureDomeTop = 1.0f;

/// Squared distance from the centre of the crown's dome: 1 at its surface.
float squaredDomeDistance(const TreeState& tree, const glm::vec3& place, float top) {
    const float reach = 0.5f * tree.goal.crownWidth;
    const glm::vec2 out = glm::vec2(place) - tree.crownCentre;
    const float x = glm::dot(out, out) / (reach * reach);
    const float z = std::max(place.z / tree.goal.height - domeWidestHeight, 0.0f) / (top - domeWidestHeight);
    return x + z * z;
}

/// How much wind and drought slow a shoot: 0 at the centre of the crown, 1 at its surface.
float exposure(const TreeState& tree, const glm::vec3& place) {
    const float squared = squaredDomeDistance(tree, place, growingDomeTop);
    return std::min(squared * squared, 1.0f / exposureLoss);
}

/// Crown radius that suits the tree's present height.
float targetCrownRadius(const TreeState& tree) {
    return 0.5f * tree.goal.crownWidth * std::min(0.3f + 0.8f * tree.relativeHeight(), 1.0f);
}

/// Factor on the vigour of boughs: larger while the crown is too narrow.
float boughVigour(const TreeState& tree) {
    return tree.spread * glm::clamp(targetCrownRadius(tree) / std::max(tree.crownRadius, 0.2f), 0.6f, 1.6f);
}

/// Factor that stops shoots far outside the crown.
float outlineFactor(const TreeState& tree, const glm::vec3& place) {
    const float reach = glm::length(glm::vec2(place) - tree.crownCentre) / targetCrownRadius(tree);
    return glm::clamp((1.25f - reach) / 0.4f, 0.0f, 1.0f);
}

/// Length by which a bud grows this year, metres. It follows from the bud's share of the tree's growth, and
/// decreases with the age of its axis and towards the surface of the intended crown. Draws one random number.
float yearlyLength(TreeState& tree, const Bud& bud) {
    const TreeHabit& habit = tree.habit;
    const ShootAxis& axis = tree.axisOf(bud);
    const std::size_t rank = TreeState::rank(axis.order);
    const glm::vec3& place = tree.metamerOf(bud).position;
    const float randomFactor = axis.vigourFactor * (0.85f + 0.3f * tree.random.uniform());
    if (tree.mature && squaredDomeDistance(tree, place, matureDomeTop) > 1.0f)
        return 0.0f;
    float vigour = std::min(bud.share, maxVigour);
    if (axis.order == 0)
        vigour = std::max(vigour, minTrunkVigour);
    const float least = axis.leading && !tree.mature ? minLimbVigour : 0.0f;
    vigour *= std::max(1.0f - exposureLoss * habit.rounding * exposure(tree, place), least);
    if (axis.order > 0)
        vigour *= outlineFactor(tree, place);
    if (axis.leading)
        return randomFactor * vigour * habit.annualShoot[0] * (axis.order > 0 ? limbShoot : 1.0f);
    if (axis.order == 1)
        vigour *= boughVigour(tree);
    vigour /= 1.0f + static_cast<float>(tree.year - axis.born) / habit.halfVigour[rank];
    return randomFactor * vigour * habit.annualShoot[rank];
}

/// Golden angle, radians: rotation from whorl to whorl of a trunk, and from limb to limb.
constexpr float whorlAngle = 2.399963f;
/// Variation of vigour among the side shoots of the straightest species; crooked species have more.
constexpr float minVigourVariation = 0.2f;

/// Side buds of a node, and their weight among the other buds.
struct NodeBuds {
    int count;
    float weight;
};

NodeBuds nodeBuds(TreeState& tree, int order, float along, bool last) {
    const TreeHabit& habit = tree.habit;
    const int usual = habit.budsPerNode;
    if (habit.whorl <= 0.0f)
        return {usual, glm::mix(1.0f, along * along, habit.acrotony)};
    if (order > 0)
        return {usual, last ? 1.0f : habit.betweenWhorls};
    if (last)
        return {static_cast<int>(std::lround(habit.whorl + 0.8f * tree.random.symmetric())), 1.0f};
    return {std::max(usual, static_cast<int>(std::lround(0.5f * habit.whorl))), habit.betweenWhorls};
}

/// Random number with a triangular distribution from -1 to 1.
float triangular(Random& random) {
    const float one = random.symmetric();
    return 0.5f * (one + random.symmetric());
}

/// Position and direction of a side bud on its axis.
struct BudPlace {
    int node = 0;                        ///< Index of the metamer that bears it.
    glm::vec3 heading{0.0f, 0.0f, 1.0f}; ///< Direction of the axis there.
    int order = 0;                       ///< Branching order of the axis.
    float azimuth = 0.0f;                ///< Around the axis, radians.
    float angle = 1.0f;                  ///< From the axis, radians.
};

/// Adds a side bud and the axis of `order` that it will begin. @return the bud; valid until the next is
/// added.
Bud& addSideBud(TreeState& tree, const BudPlace& place, int order) {
    const glm::vec3 left = directionOr(glm::cross(up, place.heading), perpendicular(place.heading));
    const glm::vec3 above = glm::cross(place.heading, left);
    const float round = 1.0f - tree.habit.flat[TreeState::rank(place.order)];
    const glm::vec3 aside =
        directionOr(math::cos(place.azimuth) * left + round * math::sin(place.azimuth) * above, left);
    ShootAxis axis;
    axis.vigourFactor = 1.0f + (minVigourVariation + tree.habit.wander[1]) * triangular(tree.random);
    axis.order = order;
    axis.born = tree.year;
    Bud bud;
    bud.node = place.node;
    bud.heading =
        directionOr(math::cos(place.angle) * place.heading + math::sin(place.angle) * aside, place.heading);
    bud.axis = static_cast<int>(tree.axes.size());
    tree.axes.push_back(axis);
    tree.buds.push_back(bud);
    return tree.buds.back();
}

/// Adds the side buds at the node of the terminal bud `end`.
/// @param along share of the year's shoot below the node. @param last whether it is the shoot's last node.
void addSideBuds(TreeState& tree, const Bud& end, float along, bool last) {
    const TreeHabit& habit = tree.habit;
    const int order = tree.axisOf(end).order;
    if (order >= habit.deepest)
        return;
    const NodeBuds buds = nodeBuds(tree, order, along, last);
    if (buds.weight <= 0.0f)
        return;
    const bool whorl = habit.whorl > 0.0f && order == 0;
    float& phase = tree.axisOf(end).phase;
    phase += whorl ? whorlAngle : habit.divergence;
    BudPlace place{end.node, end.heading, order};
    const float first = phase;
    for (int i = 0; i < buds.count; ++i) {
        place.azimuth = first + (whorl ? 0.35f : 0.12f) * triangular(tree.random) +
                        glm::two_pi<float>() * static_cast<float>(i) / static_cast<float>(buds.count);
        place.angle = habit.branchAngle[TreeState::rank(order)] * (1.0f + 0.15f * triangular(tree.random));
        addSideBud(tree, place, order + 1).weight = buds.weight;
    }
}

/// Share of its height at which the trunk divides in a closed stand.
constexpr float forestTrunkTop = 0.63f;
/// Boughs above this share of the height may become limbs.
constexpr float limbBoughHeight = 0.3f;
/// Chance of this at the top of the trunk, in the open and in a closed stand.
constexpr float openPromotion = 1.3f, forestPromotion = 0.35f;
/// Angles of the uppermost and of the lowest limb / angle towards the shoulder of the crown, in the open and
/// in a closed stand, where the uppermost limb almost continues the trunk.
constexpr glm::vec2 openLimbs(0.35f, 1.7f), forestLimbs(0.1f, 1.2f);

/// Turns boughs into limbs by chance: the nearer to the top of the trunk, the more.
void promoteBoughs(TreeState& tree) {
    const float many = glm::mix(forestPromotion, openPromotion, tree.openness());
    const auto promote = [&](int axis, float z) {
        const float chance = many * (z / tree.height - limbBoughHeight) / (1.0f - limbBoughHeight);
        if (chance > 0.0f && tree.random.uniform() < chance)
            tree.axes[static_cast<std::size_t>(axis)].leading = true;
    };
    for (const Metamer& metamer : tree.metamers)
        if (metamer.order == 1 && metamer.died < 0 && tree.parentOf(metamer).order == 0)
            promote(metamer.axis, metamer.position.z);
    for (const Bud& bud : tree.buds)
        if (tree.metamerOf(bud).order == 0 && !bud.terminal)
            promote(bud.axis, tree.metamerOf(bud).position.z);
}

/// Whether the trunk is high enough to divide into limbs: from TreeHabit::trunkTop in the open, higher in a
/// closed stand.
bool trunkDissolves(const TreeState& tree) {
    const float top = tree.habit.trunkTop, share = tree.height / tree.goal.height;
    if (top >= 1.0f || share < top)
        return false;
    return share > glm::mix(std::max(top, forestTrunkTop), top, tree.openness());
}

/// Ends the trunk and adds limbs at its last nodes, aimed so that the crown gets its width: lower limbs at
/// wider angles. Some of the youngest boughs become limbs, too. @param end terminal bud of the trunk.
void dissolveTrunk(TreeState& tree, const Bud& end) {
    const int limbs = tree.habit.limbs;
    const float narrow = glm::clamp(std::sqrt(tree.spread), 0.6f, 1.2f);
    const glm::vec2 angles = glm::mix(forestLimbs, openLimbs, tree.openness());
    BudPlace place;
    place.node = end.node;
    place.azimuth = glm::pi<float>() * tree.random.symmetric();
    for (int i = 0; i < limbs; ++i) {
        const Metamer& node = tree.metamers[static_cast<std::size_t>(place.node)];
        const float above = std::max(tree.goal.height - node.position.z, 0.5f);
        const float aim = narrow * math::atan(0.5f * tree.goal.crownWidth / above);
        const float share =
            glm::mix(angles.x, angles.y, static_cast<float>(i) / static_cast<float>(limbs - 1));
        place.heading = node.heading;
        place.angle = aim * (share + 0.15f * triangular(tree.random));
        tree.axisOf(addSideBud(tree, place, 1)).leading = true;
        place.azimuth += whorlAngle + 0.4f * triangular(tree.random);
        if (node.parent > 0 && (i > 0 || limbs == 2))
            place.node = node.parent;
    }
    promoteBoughs(tree);
}

/// A bud grows as soon as its allotted length is this share of an internode.
constexpr float shortestShoot = 0.6f;
/// Lower limit of the upward pull on limbs in the open and in a closed stand, 1/m.
constexpr float openLimbRise = 0.15f, forestLimbRise = 0.15f;
/// Random bends of limbs in a closed stand / in the open.
constexpr float forestWander = 0.5f;
/// Angle of the side shoot that replaces a dead tip, and of the second one in a fork / the usual angle.
constexpr float replacementAngle = 0.55f, forkAngle = 0.95f;

/// Grows the shoots of a year from Bud::share: sets their length and direction, and adds their side buds and
/// terminal buds.
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

/// Lowest height of branches above the ground, metres.
constexpr float minShootHeight = 0.35f;
/// Years in which a bough does half of its sinking.
constexpr float sinkingYears = 12.0f;
/// Share of its lean that a stem loses as it thickens, if `rise` is 1.
constexpr float straightening = 0.6f;

/// `heading` rotated downwards by a small angle, short of the vertical.
glm::vec3 tiltDown(const glm::vec3& heading, float angle) {
    const float across = std::sqrt(heading.x * heading.x + heading.y * heading.y);
    if (across < 0.05f && heading.z < 0.0f)
        return heading;
    const float cosine = 1.0f - 0.5f * angle * angle, sine = angle - angle * angle * angle / 6.0f;
    const float goal = std::max(across * cosine + heading.z * sine, 0.02f);
    const float z = heading.z * cosine - across * sine;
    const glm::vec3 aside =
        across > 1e-4f ? glm::vec3(heading.x, heading.y, 0.0f) / across : glm::vec3(1, 0, 0);
    return directionOr(goal * aside + z * up, heading);
}

/// Computes the positions of all nodes from their headings and lengths.
void placeNodes(TreeState& tree) {
    for (std::size_t i = 1; i < tree.metamers.size(); ++i) {
        Metamer& metamer = tree.metamers[i];
        const glm::vec3& from = tree.parentOf(metamer).position;
        metamer.position = from + metamer.length * metamer.heading;
        if (metamer.order == 0 || metamer.position.z >= minShootHeight)
            continue;
        metamer.heading = directionOr({metamer.heading.x, metamer.heading.y, 0.1f}, metamer.heading);
        metamer.position = from + metamer.length * metamer.heading;
    }
}

/// Sinks boughs at their base and bends them under their weight, together with the wood that they bear.
/// Young wood sinks fastest. Boughs stay above the ground.
void sinkBoughs(TreeState& tree) {
    const TreeHabit& habit = tree.habit;
    for (std::size_t i = 1; i < tree.metamers.size(); ++i) {
        Metamer& metamer = tree.metamers[i];
        metamer.tilt = 0.0f;
        const Metamer& parent = tree.parentOf(metamer);
        const float age = static_cast<float>(tree.year - metamer.born) / sinkingYears;
        const float yearly = 1.0f / (sinkingYears * (1.0f + age) * (1.0f + age));
        if (metamer.order == 0) {
            // A nodding leader straightens as it thickens.
            const float pull = habit.hang[0] > 0.0f && tree.year - metamer.born >= 2
                                   ? 0.8f
                                   : straightening * yearly * std::max(habit.rise[0], 0.0f);
            metamer.heading =
                directionOr(metamer.heading + pull * tree.stemDirection(metamer.position.z), up);
            continue;
        }
        const std::size_t rank = TreeState::rank(metamer.order);
        const float level = std::sqrt(std::max(1.0f - metamer.heading.z * metamer.heading.z, 0.0f));
        const ShootAxis& axis = tree.axisOf(metamer);
        float bend = axis.leading ? 0.0f : habit.hang[rank] * metamer.length * level;
        if (metamer.axis != parent.axis && !axis.leading)
            bend += habit.sink[rank] * axis.vigourFactor;
        const float free = std::clamp(0.5f * (metamer.position.z - minShootHeight), 0.0f, 1.0f);
        metamer.tilt = free * std::clamp(parent.tilt + yearly * bend, -0.5f, 0.5f);
        metamer.heading = tiltDown(metamer.heading, metamer.tilt);
    }
    for (Bud& bud : tree.buds) {
        const Metamer& metamer = tree.metamerOf(bud);
        bud.heading = bud.terminal && bud.node > 0 ? metamer.heading : tiltDown(bud.heading, metamer.tilt);
    }
    placeNodes(tree);
}

} // namespace

void growYear(TreeState& tree, const ShadeGrid& light, const glm::vec3& foot) {
    ++tree.year;
    shedBranches(tree);
    allotGrowth(tree);
    ShootGrowth(tree, light, foot).grow();
    sinkBoughs(tree);
}

} // namespace osgTreeWind
