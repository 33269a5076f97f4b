// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/ShootVigour.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>

namespace osgTreeWind {
namespace {

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

} // namespace

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

} // namespace osgTreeWind
