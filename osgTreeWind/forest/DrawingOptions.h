// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// How far from all detail trees may be drawn, by the height they have on the screen, in pixels:
/// full > reduced > impostor >= 0. Laws of a branch draw every tree in full.
struct DrawingOptions {
    bool tiers = true;      ///< Off: everything in full.
    float full = 300.0f;    ///< At least this high: every vertex.
    float reduced = 90.0f;  ///< At least this high: reduced once.
    float impostor = 50.0f; ///< At least this high: reduced twice; below: an impostor. 0: no impostors.
    float blend = 0.2f;     ///< Share of a threshold over which two tiers cross-fade.
};

} // namespace osgTreeWind
