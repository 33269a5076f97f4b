// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// How far from all detail trees may be drawn, by the height they have on the screen, in pixels:
/// full > reduced > impostor >= 0. Laws of a branch draw every tree in full.
struct DrawingOptions {
    bool tiers = true;   ///< Off: everything in full.
    float full = 800.0f; ///< At least this high: all leaf cards, from four times that every vertex of bark.
                         ///< Below: ever fewer and larger cards,
    float reduced = 250.0f; ///< down to this height: the fewest.
    float impostor = 80.0f; ///< Below this height an impostor. 0: no impostors.
    float blend = 0.1f;     ///< Share of a threshold over which two tiers cross-fade.
    /// Milliseconds that the frame of a view is to take: where it takes longer, trees are drawn as if they
    /// were lower, down to a quarter. 0: none, and what is drawn does not depend on the machine.
    float budget = 0.0f;
};

} // namespace osgTreeWind
