// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// How the trees change a wind.
enum class CanopySource {
    None,   ///< Not at all: the data already include them, or each tree is treated as standing alone.
    Forest, ///< The wind is extended into the stands formed by the forest's own trees.
    Given,  ///< The wind is extended into one given stand that covers all places.
};

/// The stand into which an open wind is extended (CanopyFlow).
struct CanopySettings {
    CanopySource source = CanopySource::None; ///< Which stands are used.
    double height = 20.0;                     ///< Height of a given stand, metres.
    /// Frontal area index of a given stand: half the leaf area plus the side area of wood, per ground area.
    double frontalArea = 2.0;
    /// Height above the ground, metres, at which the wind is given; at least the canopy top. A small wood
    /// does not change the wind at 60 m (Wieringa 1986).
    double reference = 60.0;
    std::uint32_t seed = 1; ///< Seed of the turbulence among the trees.
    /// Radius of the stand around a place, metres, for CanopySource::Forest. 0: twice the mean height of the
    /// trees; set it for tiles of one forest, whose means differ.
    double reach = 0.0;
    /// Height of the stand that sets the size and speed of gusts, metres, for CanopySource::Forest. 0: the
    /// mean of the stands.
    double usualHeight = 0.0;
    double usualFrontalArea = 0.0; ///< Frontal area index of that stand; 0: the mean of the stands.
    /// Side of a square as large as the forest, metres: the longer the wind blows over trees, the more they
    /// slow it. 0: that of the forest's own trees, or endless for a given stand. 1 for a wind over trees.
    double extent = 0.0;
};

} // namespace osgTreeWind
