// SPDX-License-Identifier: MIT
// Needs limits.glsl, elementary.glsl, oscillator.glsl, rotation.glsl and flutter.glsl. Reconfiguration of foliage:
// petioles turn downwind and the blades of a cluster close to a cone around them (Vogel 1989), in total as much as the
// drag decreases in the law of motion (Rudnicki et al. 2004).

/// Drag coefficient of foliage over that in a calm, as for the crown (streamlinedShare()).
float foliageDrag(float exponent, float breeze, float upTo, float speed) {
    return streamlinedShare(exponent, breeze, upTo, speed) / streamlinedShare(exponent, breeze, upTo, 0.0f);
}

/// Effect of a wind on foliage: xyz is the pull on petioles, w the opening of the blades, 1 in a calm.
/// @param wind m/s; NaN counts as calm. @param mostPull tangent of the maximum turn of a petiole across the wind; half
/// of it is reached at 10 m/s. Averaged over all petioles, turning reduces the frontal area by 0.165 times the pull
/// (numerical result, within 0.015 up to a pull of 2.2). Closing accounts for the rest of the drag, which is
/// proportional to the square of the opening of a cone: to its area and the sine of its half-angle (Hoerner 1965: 1.17
/// flat, 0.55 at 30 degrees).
vec4 foliagePull(vec3 wind, float exponent, float breeze, float upTo, float mostPull) {
    vec3 air = vec3(bounded(wind.x, 200.0f), bounded(wind.y, 200.0f), bounded(wind.z, 200.0f));
    float square = dot(air, air);
    float speed = sqrt(square);
    vec3 lifted = air + vec3(0.0f, 0.0f, 0.3f * speed); // the wind blows blades upward rather than downward
    float pull = mostPull * square / (square + 100.0f);
    float open = min(foliageDrag(exponent, breeze, upTo, speed) / (1.0f - 0.165f * pull), 1.0f);
    return vec4(lifted * (pull / max(length(lifted), 1.0e-9f)), sqrt(open));
}

/// Rotation of a cluster by a pull, which is smaller for petioles that point into the wind, to avoid a discontinuity.
/// @param petiole unit vector. @param pull in the same axes.
vec4 downwindTurn(vec3 petiole, vec3 pull) {
    vec3 drawn = pull * (1.0f + 0.65f * dot(petiole, pull) / max(length(pull), 1.0e-9f));
    vec3 towards = petiole + drawn;
    vec3 axis = cross(petiole, drawn); // exactly zero in a calm
    float along = length(towards) + dot(petiole, towards);
    return vec4(axis, along) / sqrt(dot(axis, axis) + along * along);
}

/// Factor on the pull at a cluster, by small gusts of two sizes that run downwind through the crown, 0.9 and 2.1 times
/// per second. @param place in the tree, m. @param phases, own, leaf as in leafFlutter().
float pullOfGusts(vec3 place, vec3 pull, vec3 phases, float own, float leaf) {
    float along = dot(place, pull) / max(length(pull), 1.0e-9f);
    float jitter = 0.2f * fract(0.754878f * leaf);
    return 1.0f + 0.3f * wave(phases.x + own + jitter - 0.2f * along + 0.08f * place.z) +
           0.15f * wave(phases.z + own - jitter - 0.35f * along);
}
