// SPDX-License-Identifier: MIT
// Needs limits.glsl. Perlin's gradient noise in one dimension and 1/f^beta noise (thesis §3.2.1) on an
// integer hash, so that CPU and GPU agree.

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

/// Of octaveNoise.
int octaves() { return 6; }

/// Rate of its slowest octave over its frequency.
float slowestOctave() { return 0.125f; }

/// 1/f^beta noise in [-1, 1] (thesis §3.2.1 and its source [4]): octaves of streamNoise, each twice as fast
/// as the one before and gain = 2^((1 - beta) / 2) times as strong, with the variance of one. The slope holds
/// from 0.1 to 1.6 times the frequency for beta in [0, 3]; the 0.06 % beyond 1 are cut.
/// Time is cell + fraction in periods of the slowest octave.
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

/// The noise of the laws: octaveNoise, or for a gain of 0 streamNoise.
float motionNoise(uint stream, uint cell, float fraction, float gain) {
    if (gain > 0.0f) return octaveNoise(stream, cell, fraction, gain);
    return streamNoise(stream, cell, fraction);
}
