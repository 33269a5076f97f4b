// SPDX-License-Identifier: MIT
// Law files are both GLSL 3.30 and, with GLM, C++ (osgTreeWind/motion/laws/Laws.h): no swizzles, no inout, literals
// with f, no preprocessor. Functions of `real` are also compiled for several trees at once: no `if` on values that
// differ between trees. A file may use the files in its "Needs" line.

/// x within [-limit, limit]; 0 for NaN. limit >= 0.
real bounded(real x, real limit) {
    return x >= limit ? limit : x <= -limit ? -limit : x == x ? x : every(0.0f);
}

/// Maximum magnitude of winds, loads and parameters in the laws.
float largest() { return 1.0e30f; }

/// A limit of angles, clamped to [0, pi/2]; 0 for NaN.
real angleLimit(real maxAngle) { return max(bounded(maxAngle, every(1.5707963f)), every(0.0f)); }

/// A number of partial steps: at least 1.
real stepCount(real steps) { return max(bounded(steps, every(largest())), every(1.0f)); }
