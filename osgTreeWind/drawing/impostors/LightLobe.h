// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/MeanLight.h>

namespace osgTreeWind {

/// Light on a piece of a tree as a function of where it comes from, linear, so that pictures can hold it:
/// strength * (base + way.d / 2), d toward the light, base 1/2 of a leaf and 1/4 of bark (linearLight() of
/// shaders/light.glsl).
struct LightLobe {
    static constexpr float longest = 2.0f; ///< Of `way`.

    float strength = 1.0f;
    glm::vec3 way{0.0f}; ///< The normal where nothing stands in the way.

    /// The line nearest to what falls on a piece from the six axes, as strong as that is on a usual day.
    LightLobe(const CrownShade::Light& light, const glm::vec3& normal, bool leaf) {
        const float base = leaf ? 0.5f : 0.25f;
        const glm::vec3 from = light.above * (base + 0.5f * normal),
                        opposite = light.below * (base - 0.5f * normal);
        const glm::vec3 sums = from + opposite;
        const float mean = glm::max((sums.x + sums.y + sums.z) / (6.0f * base), 0.01f);
        way = (from - opposite) / mean;
        way *= glm::min(1.0f, longest / glm::max(glm::length(way), longest));
        strength = glm::max(MeanLight::on(light, normal, leaf) / glm::max(MeanLight::ofLobe(base, way), 0.1f),
                            0.01f);
    }
};

} // namespace osgTreeWind
