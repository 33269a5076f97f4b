// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// A branch unit at the size of its tree; metres, tree frame.
struct ScaledUnit {
    glm::vec3 base, span; ///< `span` is the vector from base to tip.
    float length, baseDiameter, tipDiameter;

    ScaledUnit(const BranchUnit& unit, const TreeScale& scale)
        : base(scale.axes * unit.base), span(scale.axes * (unit.tip - unit.base)),
          length(std::max(glm::length(span), 1.0e-6f)),
          baseDiameter(std::max(2.0f * unit.baseRadius * scale.radius, 1.0e-6f)),
          tipDiameter(std::max(2.0f * unit.tipRadius * scale.radius, 1.0e-6f)) {}

    glm::vec3 middle() const { return base + 0.5f * span; }
    float volume() const { ///< m^3
        return 0.26179939f * length *
               (baseDiameter * baseDiameter + baseDiameter * tipDiameter + tipDiameter * tipDiameter);
    }
    /// Distance from the base at which the drag on the unit acts, metres: 3/8 of the length for constant
    /// thickness, 0.263 for a tip half as thick as the base.
    float dragLever() const {
        return length * (0.375f - 0.224f * (1.0f - std::clamp(tipDiameter / baseDiameter, 0.0f, 1.0f)));
    }
    glm::vec3 direction() const {
        return glm::length(span) > 0.0f ? glm::normalize(span) : glm::vec3(0.0f, 0.0f, 1.0f);
    }
};

/// Whether unit `i` continues the axis of its parent, such as the trunk or a branch.
inline bool continuesParentAxis(const std::vector<BranchUnit>& units, std::size_t i) {
    return units[i].parent >= 0 && units[static_cast<std::size_t>(units[i].parent)].level == units[i].level;
}

/// Distance from the base of each unit to the tip of its axis, metres.
inline std::vector<float> distancesToAxisTip(const std::vector<BranchUnit>& units, const TreeScale& scale) {
    std::vector<float> reaches(units.size(), 0.0f);
    for (std::size_t i = units.size(); i-- > 0;) {
        reaches[i] += ScaledUnit(units[i], scale).length;
        if (continuesParentAxis(units, i))
            reaches[static_cast<std::size_t>(units[i].parent)] = reaches[i];
    }
    return reaches;
}

} // namespace osgTreeWind
