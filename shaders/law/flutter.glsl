// SPDX-License-Identifier: MIT
// Needs limits.glsl. The flutter of leaves without a state (osgTreeWind/motion/laws/StatelessFlutter.h): angles are waves
// of time, in step with nothing but the leaf itself. About 70 operations a vertex, none of them transcendental.

/// Share of its largest angles that a leaf takes in a wind, m/s: 0 in calm, a fifth where leaves begin to rustle
/// (1.6 m/s), half in a gentle breeze, which keeps them in motion (3.4 m/s; Beaufort 2 and 3), toward 1.
float flutterAmplitude(float speed) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (v * v + 10.0f);
}

/// A sine of period 1 but for 0.0011: two parabolas, rounded.
float wave(float turns) {
    float t = turns - floor(turns) - 0.5f;
    float parabola = t * (8.0f - 16.0f * abs(t));
    return parabola * (-0.775f - 0.225f * abs(parabola));
}

/// (motionAngleX, motionAngleZ, totalRotaAngle) of a leaf cluster, radians, as leafRotation() takes them.
/// @param amplitude flutterAmplitude(). @param phases flutterPhases(): time in periods, wrapped.
/// @param own number of the tree, [0, 1). @param leaf index in the tree.
/// @param limits flutterLimits(): maxMotionAngleX, maxMotionAngleZ, maxRotationAngle, linkedFactor.
vec3 leafFlutter(float amplitude, vec3 phases, float own, float leaf, vec4 limits) {
    float a = fract(0.618034f * leaf + own);
    float b = fract(0.754878f * leaf + 7.0f * own);
    float x = 0.6f * wave(phases.x + a) + 0.4f * wave(phases.z + b);
    float z = 0.6f * wave(phases.y + b) - 0.4f * wave(phases.z + a);
    float angleX = bounded(amplitude * limits.x * x, limits.x);
    float angleZ = bounded(amplitude * limits.y * z, limits.y);
    float rotation = amplitude * limits.z * 0.5f * (x + z) + limits.w * angleX; // as in appendix D
    return vec3(angleX, angleZ, bounded(rotation, limits.z));
}
