// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/CanopyMap.h>

#include <glm/common.hpp>

#include <algorithm>

namespace osgTreeWind {

float CanopyCell::shelterAt(float speed) const {
    const float at = std::clamp(speed / speedStep, 0.0f, static_cast<float>(speeds - 1));
    const auto low = std::min(static_cast<std::size_t>(at), speeds - 2);
    return shelter[low] + (at - static_cast<float>(low)) * (shelter[low + 1] - shelter[low]);
}

void CanopyMap::refer(float height) {
    reference = std::max(height, usual.profile.height);
    for (const CanopyCell& one : cells)
        reference = std::max(reference, one.profile.height);
    const auto scale = [&](CanopyCell& one) {
        one.top = one.closure > 0.0f ? 1.0f / one.profile.mean(reference) : 1.0f;
    };
    scale(usual);
    std::for_each(cells.begin(), cells.end(), scale);
}

float CanopyMap::crownsAt(const glm::vec2& place) const {
    if (everywhere)
        return usual.crowns;
    const glm::vec2 at = glm::floor(place / cell + 0.5f) - glm::vec2(first);
    if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(width) &&
          at.y < static_cast<float>(length)))
        return 0.0f;
    return cells[static_cast<std::size_t>(at.y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(at.x)]
        .crowns;
}

CanopyAt CanopyMap::at(const glm::vec2& place, float speed) const {
    if (everywhere)
        return {usual.closure, usual.profile, usual.top, usual.shelterAt(speed)};
    // Places of a map do not depend on how far it goes: a part of a forest has the same cells as the whole.
    const glm::vec2 middle = place / cell, low = glm::floor(middle), at = low - glm::vec2(first);
    CanopyAt sum;
    if (!(at.x >= 0.0f && at.y >= 0.0f && at.x < static_cast<float>(width - 1) &&
          at.y < static_cast<float>(length - 1)))
        return sum; // the outermost cells are open country too
    const auto x = static_cast<std::size_t>(at.x), y = static_cast<std::size_t>(at.y);
    const float east = middle.x - low.x, north = middle.y - low.y;
    const float shares[4] = {(1.0f - east) * (1.0f - north), east * (1.0f - north), (1.0f - east) * north,
                             east * north};
    const CanopyCell* corner = &cells[y * static_cast<std::size_t>(width) + x];
    const CanopyCell* corners[4] = {corner, corner + 1, corner + width, corner + width + 1};
    float top = 0.0f, shelter = 0.0f;
    for (int i = 0; i < 4; ++i) { // what a stand is like counts as far as there is one
        const float weight = shares[i] * corners[i]->closure;
        if (weight > 0.0f) {
            sum.closure += weight;
            sum.profile.height += weight * corners[i]->profile.height;
            sum.profile.friction += weight * corners[i]->profile.friction;
            sum.profile.attenuation += weight * corners[i]->profile.attenuation;
            top += weight * corners[i]->top;
            shelter += weight * corners[i]->shelterAt(speed);
        }
    }
    if (!(sum.closure > 0.0f))
        return {};
    const float each = 1.0f / sum.closure;
    if (sum.closure > 0.999f)
        sum.closure = 1.0f; // but for rounding
    sum.profile.height *= each;
    sum.profile.friction *= each;
    sum.profile.attenuation *= each;
    sum.top = top * each;
    sum.shelter = shelter * each;
    return sum;
}

} // namespace osgTreeWind
