// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/MeanLight.h>

namespace osgTreeWind {

/// Light on a piece of a tree as a linear function of the direction d toward the light, which impostors can
/// store: strength * (base + gradient.d / 2), base 1/2 for a leaf, 1/4 for bark (shaders/light.glsl).
struct LightLobe {
    static constexpr float maxGradient = 2.0f; ///< Largest length of `gradient`.

    float strength = 1.0f;
    glm::vec3 gradient{0.0f}; ///< The normal for an unshaded piece.

    /// Fits the model to the light from the six axes, with the mean strength of a typical day (MeanLight).
    LightLobe(const CrownShade::Light& light, const glm::vec3& normal, bool leaf) {
        const float base = leaf ? 0.5f : 0.25f;
        const glm::vec3 from = light.above * (base + 0.5f * normal),
                        opposite = light.below * (base - 0.5f * normal);
        const glm::vec3 sums = from + opposite;
        const float mean = glm::max((sums.x + sums.y + sums.z) / (6.0f * base), 0.01f);
        gradient = (from - opposite) / mean;
        gradient *= glm::min(1.0f, maxGradient / glm::max(glm::length(gradient), maxGradient));
        strength = glm::max(
            MeanLight::on(light, normal, leaf) / glm::max(MeanLight::ofLobe(base, gradient), 0.1f), 0.01f);
    }
};

} // namespace osgTreeWind
