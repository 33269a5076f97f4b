// SPDX-License-Identifier: MIT
#pragma once

namespace osgTreeWind {

/// Level-of-detail thresholds, as heights of a tree on the screen in pixels: full > reduced > impostor >= 0.
/// The thesis' laws draw all trees in full detail.
struct DrawingOptions {
    bool tiers = true;      ///< False: full detail at any height.
    float full = 800.0f;    ///< From this height, all leaf cards; from four times it, every bark vertex.
    float reduced = 250.0f; ///< Below this height, the fewest leaf cards; up to `full`, their number grows.
    float impostor = 80.0f; ///< Below this height, an impostor. 0: no impostors.
    float blend = 0.1f;     ///< Share of a threshold over which two levels cross-fade.
    /// Target duration of a view's frame in milliseconds. In slower frames, trees are drawn as if they were
    /// lower, down to a quarter. 0: no target, so that the picture does not depend on the machine's speed.
    float budget = 0.0f;
    /// Factor on linear colours before they are encoded. 0: that of the define EXPOSURE
    /// (shaders/encode.glsl).
    float exposure = 0.0f;
};

} // namespace osgTreeWind
