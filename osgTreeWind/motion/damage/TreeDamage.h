// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/TreeId.h>

#include <glm/vec3.hpp>

#include <functional>

namespace osgTreeWind {

enum class DamageKind { Uprooted, Snapped };

/// A tree that the wind has brought down.
struct TreeDamage {
    TreeId tree = noTree;
    DamageKind kind = DamageKind::Uprooted;
    unsigned unit = 0;    ///< Of its trunk: about whose base it falls.
    float moment = 0.0f;  ///< At its foot when it failed, N m; beyond what its roots or its stem bear,
    float limit = 0.0f;   ///< N m.
    glm::vec3 wind{0.0f}; ///< In its crown then, scene axes, m/s.
};

using DamageCallback = std::function<void(const TreeDamage&)>;

} // namespace osgTreeWind
