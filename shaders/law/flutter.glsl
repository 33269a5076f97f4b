// SPDX-License-Identifier: MIT
// Needs limits.glsl. The flutter of leaves without a state (osgTreeWind/motion/laws/StatelessFlutter.h): angles are waves
// of time, in step with nothing but the leaf itself. About 90 operations a vertex, none of them transcendental.

/// How much a wind, m/s, rolls and turns leaves over as its gusts pass: 0 in a calm, half at 4 m/s, which keeps leaves in
/// motion (Beaufort 3), toward 1.
float flutterAmplitude(float speed) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (v * v + 16.0f);
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

/// (motionAngleX, motionAngleZ, totalRotaAngle) of a leaf cluster, radians, as leafRotation() takes them: it rocks,
/// and where the wind holds it taut, it shivers, four times as fast. It rolls with the gusts that pass.
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
    float rotation = limits.z * (0.5f * (x + z) + rolled) + limits.w * angleX; // but for gusts as in appendix D
    return vec3(angleX, angleZ, bounded(rotation, limits.z));
}

/// Share of the leaves of a cluster that a wind has turned over on their own stalks: the tauter it holds them, and as
/// small gusts pass. @param gust pullOfGusts().
float turnedOver(float speed, float gust) {
    float share = 0.8f * flutterTautness(speed) + 1.3f * (gust - 1.0f);
    return flutterAmplitude(speed) * min(max(share, 0.0f), 1.0f);
}

/// How far single leaves of a cluster move by themselves, over their size: with the square of a breeze, so that their speed
/// is that of measured leaves (Goldshmid, Dabiri and Sader, arXiv 2504.10584), as far as
/// .6; less where the wind holds them taut.
/// @param stiffness square of the wind, (m/s)^2, that would move them by their size: leafTremble().
float trembleShare(float speed, float stiffness) {
    float v = bounded(speed, 1.0e15f);
    return v * v / (1.67f * v * v + stiffness) * (1.0f - 0.8f * flutterTautness(speed));
}

/// Where single leaves near a corner of a cluster's card are on their way, each part in [-1, 1].
/// @param corner in the leaf frame, m.
vec3 trembleWave(vec3 corner, vec3 phases, float own, float leaf) {
    float a = fract(0.618034f * leaf + own) + dot(corner, vec3(1.7f, -0.9f, 1.2f));
    float b = fract(0.754878f * leaf + 3.0f * own) + dot(corner, vec3(0.6f, 1.8f, -1.3f));
    return vec3(wave(3.0f * phases.y + a), wave(2.0f * phases.z + b), wave(5.0f * phases.x + a + b));
}
