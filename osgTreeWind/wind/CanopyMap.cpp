// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyMap.h>

#include <glm/common.hpp>
#include <glm/vec4.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

glm::vec2 shelterOf(const CanopyCell& cell, const CanopySpeedStep& step) {
    return {cell.shelter[step.low], cell.shelter[step.low + 1]};
}

} // namespace

CanopySpeedStep::CanopySpeedStep(float speed) {
    const float at =
        std::clamp(speed / CanopyCell::speedStep, 0.0f, static_cast<float>(CanopyCell::speedCount - 1));
    low = std::min(static_cast<std::size_t>(at), CanopyCell::speedCount - 2);
    share = at - static_cast<float>(low);
}

void CanopyMap::setReference(float height) {
    reference = std::max(height, usual.profile.height);
    for (const CanopyCell& one : cells)
        reference = std::max(reference, one.profile.height);
    const auto scale = [&](CanopyCell& one) {
        one.topSpeedRatio = one.closure > 0.0f ? one.profile.topSpeedRatio(reference, extent) : 1.0f;
    };
    scale(usual);
    std::for_each(cells.begin(), cells.end(), scale);
}

float CanopyMap::crownCoverAt(const glm::vec2& place) const {
    if (isUniform)
        return usual.crownCover;
    const glm::vec2 at = glm::floor(place / cell + 0.5f) - glm::vec2(first);
    if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(width) &&
          at.y < static_cast<float>(length)))
        return 0.0f;
    return cells[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(at.x)]
        .crownCover;
}

CanopySample CanopyMap::at(const glm::vec2& place, const CanopySpeedStep& step) const {
    if (isUniform)
        return {usual.closure, usual.profile, usual.topSpeedRatio, shelterOf(usual, step)};
    // Cells are aligned with the origin, so that a tile has the same cells as the whole forest.
    const glm::vec2 middle = place / cell, at = middle - glm::vec2(first);
    if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(width - 1) &&
          at.y < static_cast<float>(length - 1)))
        return {}; // the outermost cells are open country
    const glm::vec2 low = glm::floor(middle);
    const float east = middle.x - low.x, north = middle.y - low.y;
    const auto x = static_cast<std::size_t>(static_cast<int>(low.x) - first.x),
               y = static_cast<std::size_t>(static_cast<int>(low.y) - first.y);
    const CanopyCell* corner = &cells[y * static_cast<std::size_t>(width) + x];
    // Cells are weighted by closure, so that open country does not affect the properties of a stand.
    float closure = 0.0f;
    glm::vec4 stand(0.0f);
    glm::vec2 shelter(0.0f);
    const auto add = [&](const CanopyCell& one, float share) {
        const float weight = share * one.closure;
        closure += weight;
        stand += weight * glm::vec4(one.profile.height, one.profile.friction, one.profile.attenuation,
                                    one.topSpeedRatio);
        shelter += weight * shelterOf(one, step);
    };
    add(corner[0], (1.0f - east) * (1.0f - north));
    add(corner[1], east * (1.0f - north));
    add(corner[width], (1.0f - east) * north);
    add(corner[width + 1], east * north);
    if (!(closure > 0.0f))
        return {};
    const float each = 1.0f / closure;
    stand *= each;
    return {closure > 0.999f ? 1.0f : closure, // removes rounding errors
            {stand.x, stand.y, stand.z},
            stand.w,
            shelter * each};
}

} // namespace osgTreeWind
