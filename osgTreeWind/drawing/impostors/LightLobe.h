// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <array>

namespace osgTreeWind {

/// Light of a usual day on a piece of a tree (shaders/light.glsl): of a sun half way up, in the mean over
/// where it stands, and of the sky. By it forms of a tree are made as bright as the tree drawn in full.
struct MeanLight {
    static constexpr float sky = 0.3f; ///< Over that of the sun.

    /// What falls on a leaf, or on bark.
    static float on(const CrownShade::Light& light, const glm::vec3& normal, bool leaf) {
        constexpr float level = 0.70710678f, cross = 0.5f; // of a direction half way up
        static constexpr std::array<glm::vec3, 8> toSun{
            glm::vec3(level, 0.0f, level),   glm::vec3(cross, cross, level), glm::vec3(0.0f, level, level),
            glm::vec3(-cross, cross, level), glm::vec3(-level, 0.0f, level), glm::vec3(-cross, -cross, level),
            glm::vec3(0.0f, -level, level),  glm::vec3(cross, -cross, level)};
        float sun = 0.0f;
        for (const glm::vec3& way : toSun) {
            const float facing = glm::dot(normal, way);
            sun += glm::max(leaf ? 0.5f * facing + 0.5f : facing, 0.0f) *
                   Laws().shareFrom(way, glm::vec4(light.above, light.sky), glm::vec4(light.below, 1.0f));
        }
        return sun / static_cast<float>(toSun.size()) + sky * light.sky * skyToward(normal.z);
    }
    /// What linearLight() makes of it, for a strength of 1. @param base, way as of LightLobe.
    static float ofLobe(float base, const glm::vec3& way) {
        return base + 0.35355339f * way.z + sky * skyToward(way.z);
    }

private:
    /// Luminance of the sky on a piece whose normal has this height.
    static float skyToward(float up) { return glm::mix(0.72f, 1.19f, 0.5f + 0.5f * up); }
};

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
