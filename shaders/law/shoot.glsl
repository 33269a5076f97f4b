// SPDX-License-Identifier: MIT
// Needs limits.glsl and flutter.glsl. Additional sway of the thin ends of boughs without a state, which the modes of
// the tree do not include: waves with different phases at each place, at 1.4 to 3.2 times the frequency of the leaves.

/// Displacement of a place relative to its unit, metres: it grows along the shoot, is a third as large vertically as
/// horizontally, and zero in a calm.
/// @param place at rest, m. @param reach distance along thin wood from thick wood, m. @param speed of the wind at the
/// unit, m/s. @param phases, own as in leafFlutter().
vec3 shootSway(vec3 place, float reach, float speed, vec3 phases, float own) {
    float v = bounded(speed, 1.0e15f);
    float length = min(reach, 2.0f);
    float width = 0.66f * length * sqrt(length) * v * v / (v * v + 600.0f);
    float a = own + dot(place, vec3(0.83f, -0.47f, 0.59f));
    float b = 3.0f * own + dot(place, vec3(0.31f, 0.89f, -0.67f));
    float c = 5.0f * own + dot(place, vec3(-0.71f, 0.37f, 0.79f));
    float x = 0.7f * wave(2.0f * phases.x + a) + 0.3f * wave(2.0f * phases.z + b);
    float y = 0.7f * wave(phases.z + c) + 0.3f * wave(2.0f * phases.y + a);
    float z = 0.7f * wave(2.0f * phases.y + b) + 0.3f * wave(2.0f * phases.z + c);
    return width * vec3(x, y, 0.33f * z);
}
