// SPDX-License-Identifier: MIT
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace osgTreeWind {

/// Luminance of a linear colour with the primaries of sRGB (Rec. 709), as in shaders/encode.glsl.
inline float luminance(const glm::vec3& color) {
    return glm::dot(color, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

} // namespace osgTreeWind
