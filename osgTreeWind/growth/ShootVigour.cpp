// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/ShootVigour.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

/// Largest vigour of a shoot; one in full light without rivals has 1.
constexpr float mostVigour = 1.25f;
/// Smallest vigour of the trunk's shoot, whatever its light.
constexpr float leaderVigour = 0.8f;
/// Smallest share that a limb keeps at the outside of the crown, so that the tree gets its height.
constexpr float limbVigour = 0.12f;
/// Yearly shoot of a limb over that of the trunk.
constexpr float limbShoot = 0.8f;
/// Share of its vigour that a shoot loses at the outside of the crown, where `rounding` is 1.
constexpr float outsideLoss = 0.8f;
/// Height at which the crown's dome is widest over that of the tree.
constexpr float domeMiddle = 0.4f;
/// Height of the dome's top over that of the tree, while the tree grows and when it is mature.
constexpr float growingDome = 1.06f, matureDome = 1.0f;

/// Distance from the middle of the crown's dome, squared: 1 at its surface.
float outside(const TreeState& tree, const glm::vec3& place, float top) {
    const float reach = 0.5f * tree.goal.crownWidth;
    const glm::vec2 out = glm::vec2(place) - tree.middle;
    const float x = glm::dot(out, out) / (reach * reach);
    const float z = std::max(place.z / tree.goal.height - domeMiddle, 0.0f) / (top - domeMiddle);
    return x + z * z;
}

/// How much wind and drought slow a shoot: 0 in the middle of the crown, 1 at its surface.
float exposure(const TreeState& tree, const glm::vec3& place) {
    const float share = outside(tree, place, growingDome);
    return std::min(share * share, 1.0f / outsideLoss);
}

/// Half the width that the crown should have at the height of the tree.
float wantedReach(const TreeState& tree) {
    return 0.5f * tree.goal.crownWidth * std::min(0.3f + 0.8f * tree.grown(), 1.0f);
}

/// Vigour of boughs: more while the crown is too narrow.
float boughVigour(const TreeState& tree) {
    return tree.spread * glm::clamp(wantedReach(tree) / std::max(tree.reach, 0.2f), 0.6f, 1.6f);
}

/// Shoots far outside of the crown stop.
float room(const TreeState& tree, const glm::vec3& place) {
    const float reach = glm::length(glm::vec2(place) - tree.middle) / wantedReach(tree);
    return glm::clamp((1.25f - reach) / 0.4f, 0.0f, 1.0f);
}

} // namespace

float yearlyLength(TreeState& tree, const Bud& bud) {
    const TreeHabit& habit = tree.habit;
    const ShootAxis& axis = tree.axisOf(bud);
    const std::size_t rank = TreeState::rank(axis.order);
    const glm::vec3& place = tree.metamerOf(bud).position;
    const float luck = axis.luck * (0.85f + 0.3f * tree.random.uniform());
    if (tree.mature && outside(tree, place, matureDome) > 1.0f)
        return 0.0f;
    float vigour = std::min(bud.share, mostVigour);
    if (axis.order == 0)
        vigour = std::max(vigour, leaderVigour);
    const float least = axis.leading && !tree.mature ? limbVigour : 0.0f;
    vigour *= std::max(1.0f - outsideLoss * habit.rounding * exposure(tree, place), least);
    if (axis.order > 0)
        vigour *= room(tree, place);
    if (axis.leading)
        return luck * vigour * habit.annualShoot[0] * (axis.order > 0 ? limbShoot : 1.0f);
    if (axis.order == 1)
        vigour *= boughVigour(tree);
    vigour /= 1.0f + static_cast<float>(tree.year - axis.born) / habit.halfVigour[rank];
    return luck * vigour * habit.annualShoot[rank];
}

} // namespace osgTreeWind
