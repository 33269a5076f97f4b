// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// What the trees around a tree are to it.
struct TreeCompany {
    float crowns = 0.0f; ///< Share of the ground around it that is under crowns, [0, 1]: they touch its own.
    float shelter =
        1.0f; ///< Wind between its leaves over that of the stand's air, in the wind that usually blows.
};

} // namespace osgTreeWind
