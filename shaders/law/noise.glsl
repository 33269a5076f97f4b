// SPDX-License-Identifier: MIT
// Needs limits.glsl. One-dimensional gradient noise by Perlin, and 1/f^beta noise (thesis §3.2.1), based on an integer
// hash, so that CPU and GPU agree.

/// Scrambles 32 bits (Wellons' lowbias32).
uint scrambleBits(uint bits) {
    uint x = bits;
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}

/// Number of the noise stream for an axis of a branch or leaf. @param seed of the tree. @param element index of the
/// branch or leaf. @param axis 0 to 2 for the load on a branch, 3 and 4 for the motion of a leaf.
uint noiseStream(uint seed, uint element, uint axis) {
    return scrambleBits(scrambleBits(scrambleBits(seed + 0x9e3779b9u) + element) + axis);
}

/// Uniform in [0, 1), exact.
float unitInterval(uint bits) { return float(bits >> 8u) * (1.0f / 16777216.0f); }

/// Slope of the noise at a lattice point, in [-1, 1).
float noiseGradient(uint stream, uint cell) {
    return 2.0f * unitInterval(scrambleBits(stream ^ scrambleBits(cell))) - 1.0f;
}

/// Noise in [-1, 1], mean 0, with continuous first and second derivatives. The time is cell + fraction in periods,
/// fraction in [0, 1). Streams have different phases, so that their zeros do not coincide.
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

/// Number of octaves in octaveNoise().
int octaves() { return 6; }

/// Frequency of the slowest octave over the frequency of octaveNoise().
float slowestOctave() { return 0.125f; }

/// 1/f^beta noise in [-1, 1] (thesis §3.2.1 and its source [4]): octaves of streamNoise(), each twice as fast as the
/// last one and gain = 2^((1 - beta) / 2) times as strong, normalized to the variance of one octave. The slope is
/// correct from 0.1 to 1.6 times the frequency for beta in [0, 3]. The 0.06 % of values beyond 1 are clamped.
/// The time is cell + fraction in periods of the slowest octave.
float octaveNoise(uint stream, uint cell, float fraction, float gain) {
    float sum = 0.0f;
    float squares = 0.0f;
    float strength = 1.0f;
    uint rate = 1u;
    for (int octave = 0; octave < octaves(); ++octave) {
        float time = fraction * float(rate);
        float whole = floor(time);
        uint own = scrambleBits(stream + uint(octave) * 0x9e3779b9u);
        sum = sum + strength * streamNoise(own, cell * rate + uint(whole), time - whole);
        squares = squares + strength * strength;
        strength = strength * gain;
        rate = rate * 2u;
    }
    return bounded(sum / sqrt(squares), 1.0f);
}

/// The noise of the laws: octaveNoise(), or streamNoise() for a gain of 0.
float motionNoise(uint stream, uint cell, float fraction, float gain) {
    if (gain > 0.0f) return octaveNoise(stream, cell, fraction, gain);
    return streamNoise(stream, cell, fraction);
}
