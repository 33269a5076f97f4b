// SPDX-License-Identifier: MIT
// Perlin's gradient noise in one dimension (thesis §3.2.1) on an integer hash, so that CPU and GPU agree.

/// Scrambles 32 bits (Wellons' lowbias32).
uint scrambleBits(uint bits) {
    uint x = bits;
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

/// Number of the stream for one axis of one branch or leaf of the tree with this seed.
/// Axes: 0 to 2 the load on a branch, 3 and 4 the motion of a leaf.
uint noiseStream(uint seed, uint element, uint axis) {
    return scrambleBits(scrambleBits(scrambleBits(seed + 0x9e3779b9u) + element) + axis);
}

/// Uniform in [0, 1), exact.
float unitInterval(uint bits) { return float(bits >> 8u) * (1.0f / 16777216.0f); }

/// Slope of the noise at a lattice point, in [-1, 1).
float noiseGradient(uint stream, uint cell) {
    return 2.0f * unitInterval(scrambleBits(stream ^ scrambleBits(cell))) - 1.0f;
}

/// Noise in [-1, 1], mean 0, with continuous first and second derivatives.
/// Time is cell + fraction, fraction in [0, 1), in periods; each stream has a phase of its own, so that
/// streams do not pass through zero together.
float streamNoise(uint stream, uint cell, float fraction) {
    float shifted = fraction + unitInterval(scrambleBits(stream + 0x85ebca6bu));
    uint first = cell;
    if (shifted >= 1.0f) {
        shifted = shifted - 1.0f;
        first = first + 1u;
    }
    float fade = shifted * shifted * shifted * (shifted * (shifted * 6.0f - 15.0f) + 10.0f);
    float before = noiseGradient(stream, first) * shifted;
    float after = noiseGradient(stream, first + 1u) * (shifted - 1.0f);
    return 2.0f * (before + (after - before) * fade);
}
