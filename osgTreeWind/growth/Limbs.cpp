// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/Limbs.h>

#include <osgTreeWind/base/UnitVectors.h>
#include <osgTreeWind/growth/SideBuds.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cmath>

namespace osgTreeWind {
namespace {

/// Share of its height at which the trunk divides in a closed stand.
constexpr float forestTrunkTop = 0.63f;
/// Boughs above this share of the height may become limbs.
constexpr float limbBoughHeight = 0.3f;
/// Chance of this at the top of the trunk, in the open and in a closed stand.
constexpr float openPromotion = 1.3f, forestPromotion = 0.35f;
/// Angles of the uppermost and of the lowest limb / angle towards the shoulder of the crown, in the open and
/// in a closed stand, where the uppermost limb almost continues the trunk.
constexpr glm::vec2 openLimbs(0.35f, 1.7f), forestLimbs(0.1f, 1.2f);

float arcTangent(float x) {
    return static_cast<float>(std::atan(static_cast<double>(x)));
}

/// Turns boughs into limbs by chance: the nearer to the top of the trunk, the more.
void promoteBoughs(TreeState& tree) {
    const float many = glm::mix(forestPromotion, openPromotion, tree.openness());
    const auto promote = [&](int axis, float z) {
        const float chance = many * (z / tree.height - limbBoughHeight) / (1.0f - limbBoughHeight);
        if (chance > 0.0f && tree.random.uniform() < chance)
            tree.axes[static_cast<std::size_t>(axis)].leading = true;
    };
    for (const Metamer& metamer : tree.metamers)
        if (metamer.order == 1 && metamer.died < 0 &&
            tree.metamers[static_cast<std::size_t>(metamer.parent)].order == 0)
            promote(metamer.axis, metamer.position.z);
    for (const Bud& bud : tree.buds)
        if (tree.metamerOf(bud).order == 0 && !bud.terminal)
            promote(bud.axis, tree.metamerOf(bud).position.z);
}

} // namespace

bool trunkDissolves(const TreeState& tree) {
    const float top = tree.habit.trunkTop, share = tree.height / tree.goal.height;
    if (top >= 1.0f || share < top)
        return false;
    return share > glm::mix(std::max(top, forestTrunkTop), top, tree.openness());
}

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
        const float aim = narrow * arcTangent(0.5f * tree.goal.crownWidth / above);
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

} // namespace osgTreeWind
