// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyProfile.h>

#include <glm/ext/vector_int2.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// The stand around a place, as one cell of a CanopyMap.
struct CanopyCell {
    static constexpr std::size_t speedCount = 8;
    static constexpr float speedStep = 8.0f; ///< m/s

    float closure = 0.0f;    ///< See closureOf(); 0 in open country.
    float crownCover = 0.0f; ///< Share of the ground under crowns, [0, 1].
    CanopyProfile profile;
    /// Mean wind at the top of the stand over the open one at CanopyMap::reference.
    float topSpeedRatio = 1.0f;
    /// Wind between leaves over the wind beside the crown, for mean speeds at the top of 0, speedStep, ...
    std::array<float, speedCount> shelter{};
};

/// Interpolates CanopyCell::shelter at a mean speed at the top.
struct CanopySpeedStep {
    std::size_t low;
    float share; ///< Weight of step `low` + 1.

    CanopySpeedStep(float speed); ///< @param speed m/s
    float mix(const glm::vec2& shelter) const { return shelter.x + share * (shelter.y - shelter.x); }
};

/// The stand at a place.
struct CanopySample {
    float closure = 0.0f;
    CanopyProfile profile;      ///< All 0 where the closure is 0.
    float topSpeedRatio = 1.0f; ///< As CanopyCell::topSpeedRatio.
    glm::vec2 shelter{1.0f};    ///< CanopyCell::shelter at both ends of the CanopySpeedStep.
};

/// How neighbouring trees affect a tree: by crown contact and by shelter.
struct NeighbourEffect {
    float crownCover = 0.0f; ///< Share of the ground under crowns around it, [0, 1]: contact with neighbours.
    float shelter = 1.0f;    ///< Wind between its leaves over the wind in the stand, in the mean wind.
};

/// Map of the stands of a forest, to find the stand upwind of a place. Immutable once built.
struct CanopyMap {
    glm::ivec2 first{0}; ///< Centre of the first cell, in cells from the origin.
    float cell = 1.0f;   ///< Cell size, metres.
    int width = 0, length = 0;
    std::vector<CanopyCell> cells; ///< West to east, then south to north.
    float reference = 0.0f;        ///< Height at which the wind is known, metres above the ground.
    /// Distance from a place to the centre of the stand upwind of it, and radius of that stand, metres.
    float fetch = 0.0f;
    /// CanopySettings::extent of these trees, metres; 0: the wind is that over the trees.
    float extent = 0.0f;
    CanopyCell usual;       ///< The stand that sets the size and speed of gusts.
    bool isUniform = false; ///< True: `usual` covers all places, and `cells` is empty.

    /// Sets the reference height, metres above the ground; at least the top of the highest stand.
    void setReference(float height);

    /// The stand at a place; open country outside the map. @param step of the mean wind at its top.
    CanopySample at(const glm::vec2& place, const CanopySpeedStep& step) const;
    /// Share of the ground under crowns around a place, [0, 1].
    float crownCoverAt(const glm::vec2& place) const;
};

} // namespace osgTreeWind
