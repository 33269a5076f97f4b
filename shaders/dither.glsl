// SPDX-License-Identifier: MIT
// Transition between two levels of detail of a tree by a pixel pattern, without blending. Between two levels with
// branches, leaf cards are exchanged instead (instance.glsl).

/// Bayer's 8 x 8 pattern: each of (n + 0.5) / 64 once. Integers, so that two draws agree on every pixel.
float ditherValue() {
    ivec2 p = ivec2(gl_FragCoord.xy) & 7;
    int a = p.x ^ p.y;
    int n = (a & 1) << 5 | (p.y & 1) << 4 | (a & 2) << 2 | (p.y & 2) << 1 | (a & 4) >> 1 | (p.y & 4) >> 2;
    return (float(n) + 0.5) / 64.0;
}

/// Whether a pixel is discarded. @param fade share of the pixels to draw; negative: the complement of the pixels of
/// -fade; outside (-1, 1): all pixels.
bool dithered(float fade) {
    if (abs(fade) >= 1.0)
        return false;
    return fade >= 0.0 ? ditherValue() >= fade : ditherValue() < -fade;
}

/// Noise in [0, 1), evenly distributed over small groups of pixels, independent of ditherValue() (Jimenez 2014,
/// interleaved gradient noise).
float evenNoise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}
