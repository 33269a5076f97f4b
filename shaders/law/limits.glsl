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

/// asin x for x in [-1, 1], within 3e-7 (Moshier's Cephes); the built-in one is off by 2e-4 on some GPUs,
/// which would add up from frame to frame.
float arcSine(float x) {
    float a = abs(x);
    bool far = a > 0.5f;
    float z = a * a;
    if (far) {
        z = 0.5f * (1.0f - a);
        a = sqrt(z);
    }
    float p = ((4.2163199048e-2f * z + 2.4181311049e-2f) * z + 4.5470025998e-2f) * z + 7.4953002686e-2f;
    p = p * z + 1.6666752422e-1f;
    float y = a + a * z * p;
    if (far) y = 1.5707963f - 2.0f * y;
    return x < 0.0f ? -y : y;
}
