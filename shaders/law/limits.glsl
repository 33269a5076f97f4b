// SPDX-License-Identifier: MIT
// Law files are GLSL 3.30 and, under GLM, C++ at once (osgTreeWind/motion/laws/Laws.h): no swizzles, no inout,
// literals with f, no preprocessor. Those that say `real` are compiled for several trees at once, too: no `if`
// on what differs from tree to tree. A file may use those named in its "Needs" line.

/// x within [-limit, limit]; 0 for NaN. limit >= 0.
real bounded(real x, real limit) {
    return x >= limit ? limit : x <= -limit ? -limit : x == x ? x : every(0.0f);
}

/// Largest magnitude of wind, load or parameter that a law works with.
float largest() { return 1.0e30f; }

/// A limit on an angle, itself within [0, pi/2]; 0 for NaN.
real angleLimit(real maxAngle) { return max(bounded(maxAngle, every(1.5707963f)), every(0.0f)); }

/// A number of partial steps: at least 1.
real stepCount(real steps) { return max(bounded(steps, every(largest())), every(1.0f)); }
