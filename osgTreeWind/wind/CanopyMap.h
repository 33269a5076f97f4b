// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/wind/CanopyProfile.h>

#include <glm/ext/vector_int2.hpp>
#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace osgTreeWind {

/// The stand around a place.
struct CanopyCell {
    static constexpr std::size_t speeds = 8;
    static constexpr float speedStep = 8.0f; ///< m/s

    float closure = 0.0f; ///< closureOf() it: 0 is open country.
    float crowns = 0.0f;  ///< Share of the ground that is under crowns, at most 1.
    CanopyProfile profile;
    float top = 1.0f; ///< Mean at the top over that at CanopyMap::reference.
    /// The wind between leaves over that of free air there, for mean speeds at the top of 0, speedStep, ...
    std::array<float, speeds> shelter{};
};

/// The same at one mean speed at the top.
struct CanopyAt {
    float closure = 0.0f;
    CanopyProfile profile; ///< Nothing where the closure is 0.
    float top = 1.0f;      ///< As CanopyCell has it.
    float shelter = 1.0f;
};

/// What the trees around a tree are to it.
struct TreeCompany {
    float crowns = 0.0f; ///< Share of the ground around it that is under crowns, [0, 1]: they touch its own.
    float shelter =
        1.0f; ///< Wind between its leaves over that of the stand's air, in the wind that usually blows.
};

/// The stands of a forest from above: which one the air comes from at each place. Immutable once made.
struct CanopyMap {
    glm::ivec2 first{0}; ///< The first cell's middle, in cells from the origin.
    float cell = 1.0f;   ///< Metres.
    int width = 0, length = 0;
    std::vector<CanopyCell> cells; ///< Eastward, then northward; those of no trees have closure 0.
    float reference = 0.0f;        ///< Where the wind is given, metres above the ground; see refer().
    /// How far upwind of a place the middle of its stand is; it reaches as far to all sides.
    float fetch = 0.0f;
    CanopyCell usual;        ///< What gusts have their size and pace from.
    bool everywhere = false; ///< `usual` is, and there are no cells.

    /// Has the wind be given at `height`, metres above the ground, or at the highest canopy's top.
    void refer(float height);

    /// The stand at a place; outside of the map it is open country. @param speed mean at the top, m/s.
    CanopyAt at(const glm::vec2& place, float speed) const;
    /// Share of the ground around a place that is under crowns, [0, 1].
    float crownsAt(const glm::vec2& place) const;
};

} // namespace osgTreeWind
