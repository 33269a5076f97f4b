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

} // namespace osgTreeWind
