// SPDX-License-Identifier: MIT
// Law files are GLSL 3.30 and, under GLM, C++ at once (osgTreeWind/motion/Laws.h): no swizzles, no inout,
// literals with f, no preprocessor. A file may use those named in its "Needs" line.

/// x within [-limit, limit]; 0 for NaN. limit >= 0.
float bounded(float x, float limit) {
    if (x >= limit) return limit;
    if (x <= -limit) return -limit;
    if (x > -limit && x < limit) return x;
    return 0.0f;
}

/// Largest magnitude of wind, load or parameter that a law works with.
float largest() { return 1.0e30f; }

/// `bounded` by component.
vec3 boundedVector(vec3 v, float limit) {
    return vec3(bounded(v.x, limit), bounded(v.y, limit), bounded(v.z, limit));
}

/// A limit on an angle, itself within [0, pi/2]; 0 for NaN.
float angleLimit(float maxAngle) { return max(bounded(maxAngle, 1.5707963f), 0.0f); }

/// A number of partial steps: at least 1.
float stepCount(float steps) { return max(bounded(steps, largest()), 1.0f); }
