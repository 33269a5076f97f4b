// SPDX-License-Identifier: MIT
// Needs limits.glsl. The flutter of leaves without a state (osgTreeWind/motion/laws/StatelessFlutter.h): angles are
// waves of time, with a different phase for each leaf. About 90 operations per vertex, none of them transcendental.

/// Amplitude with which gusts roll and turn over leaves, [0, 1): 0 in a calm, 0.5 at 4 m/s, which keeps leaves in
/// motion (Beaufort 3). @param speed of the wind, m/s.
float flutterAmplitude(float speed) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (v * v + 16.0f);
}

/// Tautness of leaves in a wind, [0, 1), 0.5 at 14 m/s: from 10 to 20 m/s, leaves with long petioles flutter less, as
/// they close (Vogel 1989).
float flutterTautness(float speed) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (v * v + 200.0f);
}

/// A sine of period 1, within 0.0011, from two parabolas.
float wave(float turns) {
    float t = turns - floor(turns) - 0.5f;
    float parabola = t * (8.0f - 16.0f * abs(t));
    return parabola * (-0.775f - 0.225f * abs(parabola));
}

/// (motionAngleX, motionAngleZ, totalRotaAngle) of a leaf cluster for leafRotation(), radians. The cluster rocks; a
/// taut one shivers, four times as fast. It rolls with the gusts.
/// @param speed of the wind, m/s. @param gust pullOfGusts(). @param phases flutterPhases(): time in periods, wrapped.
/// @param own number of the tree, [0, 1). @param leaf index in the tree.
/// @param limits flutterLimits(): maxMotionAngleX, maxMotionAngleZ, maxRotationAngle, linkedFactor.
vec3 leafFlutter(float speed, float gust, vec3 phases, float own, float leaf, vec4 limits) {
    float taut = flutterTautness(speed);
    float rock = taut * (1.0f - 0.8f * taut);
    float shiver = 0.2f * taut * taut;
    float a = fract(0.618034f * leaf + own);
    float b = fract(0.754878f * leaf + 7.0f * own);
    float x = rock * (0.6f * wave(phases.x + a) + 0.4f * wave(phases.z + b)) + shiver * wave(4.0f * phases.y + a);
    float z = rock * (0.6f * wave(phases.y + b) - 0.4f * wave(phases.z + a)) + shiver * wave(4.0f * phases.z + b);
    float angleX = bounded(limits.x * x, limits.x);
    float angleZ = bounded(limits.y * z, limits.y);
    float rolled = 2.0f * flutterAmplitude(speed) * (gust - 1.0f);
    float rotation = limits.z * (0.5f * (x + z) + rolled) + limits.w * angleX; // as in appendix D, plus gusts
    return vec3(angleX, angleZ, bounded(rotation, limits.z));
}

/// Share of the leaves of a cluster that are turned over on their petioles, by tautness and by small gusts.
/// @param gust pullOfGusts().
float turnedOver(float speed, float gust) {
    float share = 0.8f * flutterTautness(speed) + 1.3f * (gust - 1.0f);
    return flutterAmplitude(speed) * min(max(share, 0.0f), 1.0f);
}

/// Amplitude of the single leaves of a cluster, over their size: proportional to the square of a breeze, at the
/// measured speed of leaves (Goldshmid, Dabiri and Sader, arXiv 2504.10584), up to 0.6; less if they are taut.
/// @param stiffness square of the wind speed, (m/s)^2, that would move them by their size: leafTremble().
float trembleShare(float speed, float stiffness) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (1.67f * v * v + stiffness) * (1.0f - 0.8f * flutterTautness(speed));
}

/// Displacement of single leaves near a corner of a cluster's card, over the amplitude, each component in [-1, 1].
/// @param corner in the leaf frame, m.
vec3 trembleWave(vec3 corner, vec3 phases, float own, float leaf) {
    float a = fract(0.618034f * leaf + own) + dot(corner, vec3(1.7f, -0.9f, 1.2f));
    float b = fract(0.754878f * leaf + 3.0f * own) + dot(corner, vec3(0.6f, 1.8f, -1.3f));
    return vec3(wave(3.0f * phases.y + a), wave(2.0f * phases.z + b), wave(5.0f * phases.x + a + b));
}
