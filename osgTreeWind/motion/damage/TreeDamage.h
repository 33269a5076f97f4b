// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/TreeId.h>

#include <glm/vec3.hpp>

#include <functional>

namespace osgTreeWind {

enum class DamageKind { Uprooted, Snapped, BoughTorn };

/// What the wind has brought down of a tree: all of it, or a bough.
struct TreeDamage {
    TreeId tree = noTree;                   ///< The one it happened to.
    DamageKind kind = DamageKind::Uprooted; ///< What happened.
    unsigned unit = 0;                      ///< Of its trunk or the bough: about whose base it falls.
    float moment = 0.0f;  ///< At its foot, or at the base of the bough, when that failed, N m; beyond what
    float limit = 0.0f;   ///< roots, stem or bough bear, N m.
    glm::vec3 wind{0.0f}; ///< In its crown then, scene axes, m/s.
};

using DamageCallback = std::function<void(const TreeDamage&)>;

} // namespace osgTreeWind
