// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownShade.h>
#include <osgTreeWind/motion/laws/Laws.h>

#include <array>

namespace osgTreeWind {

/// Light of a typical day on a piece of a tree (shaders/light.glsl): the mean over eight azimuths of a sun at
/// an elevation of 45 degrees, plus the sky. All tiers of a tree are made equally bright in this light.
struct MeanLight {
    static constexpr float sky = 0.3f; ///< Light of the sky relative to the sun.

    /// Light on a leaf or on bark.
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
    /// Light by the model of linearLight() for a strength of 1. @param base, gradient of the LightLobe.
    static float ofLobe(float base, const glm::vec3& gradient) {
        return base + 0.35355339f * gradient.z + sky * skyToward(gradient.z);
    }

private:
    /// Luminance of the sky for a piece. @param up z component of its normal.
    static float skyToward(float up) { return glm::mix(0.72f, 1.19f, 0.5f + 0.5f * up); }
};

} // namespace osgTreeWind
