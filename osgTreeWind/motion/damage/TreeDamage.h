// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/TreeId.h>

#include <glm/vec3.hpp>

#include <functional>

namespace osgTreeWind {

enum class DamageKind { Uprooted, Snapped, BoughTorn };

/// Damage by wind: a fallen tree or a torn bough.
struct TreeDamage {
    TreeId tree{};                          ///< The damaged tree.
    DamageKind kind = DamageKind::Uprooted; ///< Kind of damage.
    unsigned unit = 0;    ///< The part falls about the base of this unit of the trunk or bough.
    float moment = 0.0f;  ///< At failure, at the foot of the tree or the base of the bough, N m.
    float limit = 0.0f;   ///< The resistance exceeded, of roots, stem or bough, N m.
    glm::vec3 wind{0.0f}; ///< In the crown at failure, scene axes, m/s.
};

using DamageCallback = std::function<void(const TreeDamage&)>;

} // namespace osgTreeWind
