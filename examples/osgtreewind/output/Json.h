// SPDX-License-Identifier: MIT
#pragma once

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

/// JSON that keeps the order of its keys.
using Json = nlohmann::ordered_json;

/// Indented text. Paths that are not UTF-8 get replacement characters.
inline std::string textOf(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace);
}

inline Json vectorJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}
