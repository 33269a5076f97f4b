// SPDX-License-Identifier: MIT
// Change-over of one form of a tree to another, pixel by pixel, so that nothing is blended and nothing pops. Of two forms
// with branches it goes leaf card by leaf card: instance.glsl.

/// Bayer's 8 x 8 pattern: each of (n + 0.5) / 64 once. Whole numbers, so that two draws agree on every pixel.
float ditherValue() {
    ivec2 p = ivec2(gl_FragCoord.xy) & 7;
    int a = p.x ^ p.y;
    int n = (a & 1) << 5 | (p.y & 1) << 4 | (a & 2) << 2 | (p.y & 2) << 1 | (a & 4) >> 1 | (p.y & 4) >> 2;
    return (float(n) + 0.5) / 64.0;
}

/// Whether a pixel is not drawn. @param fade its share of pixels; negative: those that a draw of -fade leaves out; beyond
/// -1 and 1: all that there are.
bool dithered(float fade) {
    if (abs(fade) >= 1.0)
        return false;
    return fade >= 0.0 ? ditherValue() >= fade : ditherValue() < -fade;
}

/// Even on every few pixels, in [0, 1), and nothing to do with ditherValue() (Jimenez 2014, interleaved gradient
/// noise).
float evenNoise() {
    return fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
}
