// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <array>

namespace osgTreeWind {

/// Light of a typical day on a piece of a tree (shaders/light.glsl): the mean over eight azimuths of a sun at
/// an elevation of 45 degrees, plus the sky and the ground. All tiers of a tree are made equally bright in
/// this light.
struct MeanLight {
    static constexpr float sky = 0.3f;     ///< Light of the sky relative to the sun.
    static constexpr float ground = 0.09f; ///< Light of open ground.
    static constexpr float leaf = 0.40f;   ///< Light on a leaf, mean of all normals and views.

    /// Light on a leaf or on bark.
    static float on(const CrownShade::Light& light, const glm::vec3& normal, bool isLeaf) {
        constexpr float level = 0.70710678f, cross = 0.5f; // of a direction half way up
        static constexpr std::array<glm::vec3, 8> toSun{
            glm::vec3(level, 0.0f, level),   glm::vec3(cross, cross, level), glm::vec3(0.0f, level, level),
            glm::vec3(-cross, cross, level), glm::vec3(-level, 0.0f, level), glm::vec3(-cross, -cross, level),
            glm::vec3(0.0f, -level, level),  glm::vec3(cross, -cross, level)};
        float sun = 0.0f;
        for (const glm::vec3& way : toSun) {
            const float facing = glm::dot(normal, way);
            sun += (isLeaf ? leaf + 0.25f * facing : glm::max(facing, 0.0f)) *
                   Laws().shareFrom(way, glm::vec4(light.above, light.sky), glm::vec4(light.below, 1.0f));
        }
        return sun / static_cast<float>(toSun.size()) + sky * light.sky + ground * light.ground;
    }
    /// Light by the model of linearLight() for a strength of 1. @param base, gradient of the LightLobe.
    static float ofLobe(float base, const glm::vec3& gradient) {
        return base + 0.35355339f * gradient.z + sky + ground;
    }
};

/// Light on a piece of a tree as a linear function of the direction d toward the light, which impostors can
/// store: strength * (base + gradient.d / 2), base MeanLight::leaf or 1/4 for bark (shaders/light.glsl).
struct LightLobe {
    static constexpr float maxGradient = 2.0f; ///< Largest length of `gradient`.

    float strength = 1.0f;
    glm::vec3 gradient{0.0f}; ///< For an unshaded piece the normal of bark, half that of a leaf.

    /// Fits the model to the light from the six axes, with the mean strength of a typical day (MeanLight).
    LightLobe(const CrownShade::Light& light, const glm::vec3& normal, bool leaf) {
        const float base = leaf ? MeanLight::leaf : 0.25f, slope = leaf ? 0.25f : 0.5f;
        const glm::vec3 from = light.above * (base + slope * normal),
                        opposite = light.below * (base - slope * normal);
        const glm::vec3 sums = from + opposite;
        const float mean = glm::max((sums.x + sums.y + sums.z) / (6.0f * base), 0.01f);
        gradient = (from - opposite) / mean;
        gradient *= glm::min(1.0f, maxGradient / glm::max(glm::length(gradient), maxGradient));
        strength = glm::max(
            MeanLight::on(light, normal, leaf) / glm::max(MeanLight::ofLobe(base, gradient), 0.1f), 0.01f);
    }
};

} // namespace osgTreeWind
