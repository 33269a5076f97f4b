// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/PortableMath.h>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>

namespace osgTreeWind {

/// A parallel view of a tree: transforms points of the tree's frame to right, up and toward the eye.
struct TreeView {
    glm::vec3 right, up, toEye;

    TreeView(float azimuth, float elevation) {
        const glm::vec3 level{math::cos(azimuth), math::sin(azimuth), 0.0f}, vertical{0.0f, 0.0f, 1.0f};
        right = {-level.y, level.x, 0.0f};
        up = vertical * math::cos(elevation) - level * math::sin(elevation);
        toEye = level * math::cos(elevation) + vertical * math::sin(elevation);
    }
    glm::vec3 operator()(const glm::vec3& p) const {
        return {glm::dot(p, right), glm::dot(p, up), glm::dot(p, toEye)};
    }
};

} // namespace osgTreeWind
