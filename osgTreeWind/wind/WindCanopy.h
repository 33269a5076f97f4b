// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// Whether a wind knows of the trees in it.
enum class CanopySource {
    None,   ///< It is taken as it is: it knows, or trees stand as if alone.
    Forest, ///< It does not, and is continued into stands as the forest's own trees make them.
    Given,  ///< It does not, and is continued into one stand that goes on to all sides.
};

/// The stand into which a wind from above is continued (CanopyFlow).
struct WindCanopy {
    CanopySource source = CanopySource::None; ///< Whose stands they are.
    double height = 20.0;                     ///< Of a given stand, metres.
    double frontalArea =
        2.0; ///< Of a given stand: half of its leaf area, and wood from the side, over the ground's.
    /// Metres above the ground where the wind is that of open country still. 60 is where roughness below is
    /// blended (Wieringa 1986); at least the canopy's top counts.
    double reference = 60.0;
    std::uint32_t seed = 1; ///< Of the turbulence.
    /// Of a forest's own stands, metres: how far around its middle a stand reaches. 0: twice the mean height
    /// of the trees that are there, which parts of a forest differ in.
    double reach = 0.0;
    /// Of the stand that the size and the pace of gusts among a forest's own trees go by: metres; 0: the mean
    /// of the stands that are there.
    double usualHeight = 0.0;
    double usualFrontalArea = 0.0; ///< The same, as `frontalArea`.
};

} // namespace osgTreeWind
