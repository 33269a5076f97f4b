// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

/// JSON that keeps the order of its keys.
using Json = nlohmann::ordered_json;

inline Json vectorJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
