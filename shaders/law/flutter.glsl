// SPDX-License-Identifier: MIT
// Needs limits.glsl. The flutter of leaves without a state (osgTreeWind/motion/laws/StatelessFlutter.h): angles are waves
// of time, in step with nothing but the leaf itself. About 90 operations a vertex, none of them transcendental.

/// Share of its largest angles that a leaf takes in a wind, m/s: 0 in calm, a fifth where leaves begin to rustle
/// (1.6 m/s), half in a gentle breeze, which keeps them in motion (3.4 m/s; Beaufort 2 and 3), toward 1.
float flutterAmplitude(float speed) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (v * v + 10.0f);
}

/// How taut a wind holds leaves, from 0 to 1, half at 14 m/s: from 10 to 20 m/s those with long stalks flutter less and
/// less, as they close (Vogel 1989).
float flutterTautness(float speed) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (v * v + 200.0f);
}

/// A sine of period 1 but for 0.0011: two parabolas, rounded.
float wave(float turns) {
    float t = turns - floor(turns) - 0.5f;
    float parabola = t * (8.0f - 16.0f * abs(t));
    return parabola * (-0.775f - 0.225f * abs(parabola));
}

/// (motionAngleX, motionAngleZ, totalRotaAngle) of a leaf cluster, radians, as leafRotation() takes them: it rocks
/// widely in a breeze; where it is held taut, it rather shivers, four times as fast. It rolls with the gusts that pass.
/// @param speed of the wind, m/s. @param gust pullOfGusts(). @param phases flutterPhases(): time in periods, wrapped.
/// @param own number of the tree, [0, 1). @param leaf index in the tree.
/// @param limits flutterLimits(): maxMotionAngleX, maxMotionAngleZ, maxRotationAngle, linkedFactor.
vec3 leafFlutter(float speed, float gust, vec3 phases, float own, float leaf, vec4 limits) {
    float amplitude = flutterAmplitude(speed);
    float taut = flutterTautness(speed);
    float rock = amplitude * (1.0f - 0.8f * taut);
    float shiver = 0.2f * amplitude * taut;
    float a = fract(0.618034f * leaf + own);
    float b = fract(0.754878f * leaf + 7.0f * own);
    float x = rock * (0.6f * wave(phases.x + a) + 0.4f * wave(phases.z + b)) + shiver * wave(4.0f * phases.y + a);
    float z = rock * (0.6f * wave(phases.y + b) - 0.4f * wave(phases.z + a)) + shiver * wave(4.0f * phases.z + b);
    float angleX = bounded(limits.x * x, limits.x);
    float angleZ = bounded(limits.y * z, limits.y);
    float rolled = 2.0f * amplitude * (gust - 1.0f);
    float rotation = limits.z * (0.5f * (x + z) + rolled) + limits.w * angleX; // but for gusts as in appendix D
    return vec3(angleX, angleZ, bounded(rotation, limits.z));
}

/// Share of the leaves of a cluster that a wind has turned over on their own stalks: the tauter it holds them, and as
/// small gusts pass. @param gust pullOfGusts().
float turnedOver(float speed, float gust) {
    float share = 0.8f * flutterTautness(speed) + 1.3f * (gust - 1.0f);
    return flutterAmplitude(speed) * min(max(share, 0.0f), 1.0f);
}
