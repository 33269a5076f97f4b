// SPDX-License-Identifier: MIT
// Needs limits.glsl, elementary.glsl, oscillator.glsl, rotation.glsl and flutter.glsl. How foliage gives way to a wind:
// petioles turn downwind and the blades of a cluster close to a cone about them (Vogel 1989), together as far as the
// drag falls that the law of motion reckons with (Rudnicki et al. 2004).

/// Drag of foliage by the wind's pressure, over that in a calm: as that of the crown falls (streamlinedShare()).
float foliageDrag(float exponent, float breeze, float upTo, float speed) {
    return streamlinedShare(exponent, breeze, upTo, speed) / streamlinedShare(exponent, breeze, upTo, 0.0f);
}

/// What a wind does to foliage: toward where it draws petioles, and how wide blades stay open, 1 in a calm.
/// @param wind m/s; what is not finite counts as calm. @param mostPull tangent of the largest turn of a petiole across
/// the wind; half of that pull is there at 10 m/s. Over all petioles, turning takes 0.165 times the pull off the frontal
/// area (numerically, within 0.015 up to a pull of 2.2); closing takes off the rest of the drag, which goes with the
/// square of how wide a cone is open: its area, and the sine of its half-angle (Hoerner 1965: 1.17 flat, 0.55 at 30
/// degrees).
vec4 foliagePull(vec3 wind, float exponent, float breeze, float upTo, float mostPull) {
    vec3 air = vec3(bounded(wind.x, 200.0f), bounded(wind.y, 200.0f), bounded(wind.z, 200.0f));
    float square = dot(air, air);
    float speed = sqrt(square);
    vec3 lifted = air + vec3(0.0f, 0.0f, 0.3f * speed); // blades are blown up rather than down
    float pull = mostPull * square / (square + 100.0f);
    float open = min(foliageDrag(exponent, breeze, upTo, speed) / (1.0f - 0.165f * pull), 1.0f);
    return vec4(lifted * (pull / max(length(lifted), 1.0e-9f)), sqrt(open));
}

/// Turn of a cluster that is pulled. Less pull on a petiole that points into the wind, so that no direction is torn
/// between two sides. @param petiole, pull in the same axes, the petiole of length 1.
vec4 downwindTurn(vec3 petiole, vec3 pull) {
    vec3 drawn = pull * (1.0f + 0.65f * dot(petiole, pull) / max(length(pull), 1.0e-9f));
    vec3 towards = petiole + drawn;
    vec3 axis = cross(petiole, drawn); // of nothing in a calm, exactly
    float along = length(towards) + dot(petiole, towards);
    return vec4(axis, along) / sqrt(dot(axis, axis) + along * along);
}

/// Factor on the pull at a cluster: small gusts of two sizes run downwind through the crown, 0.9 and 2.1 times a second.
/// @param place in the tree, m. @param phases, own, leaf as of leafFlutter().
float pullOfGusts(vec3 place, vec3 pull, vec3 phases, float own, float leaf) {
    float along = dot(place, pull) / max(length(pull), 1.0e-9f);
    float jitter = 0.2f * fract(0.754878f * leaf);
    return 1.0f + 0.3f * wave(phases.x + own + jitter - 0.2f * along + 0.08f * place.z) +
           0.15f * wave(phases.z + own - jitter - 0.35f * along);
}
