// SPDX-License-Identifier: MIT
// Change-over between two tiers pixel by pixel: what one leaves out the other draws.

/// The 8 x 8 Bayer matrix at this pixel, [0, 1).
float ditherLevel() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    int x = at.x ^ at.y, y = at.y;
    int order = (x & 1) << 5 | (y & 1) << 4 | (x & 2) << 2 | (y & 2) << 1 | (x & 4) >> 1 | (y & 4) >> 2;
    return (float(order) + 0.5) / 64.0;
}

/// Whether a pixel is left out. @param fade 1: none is; [0, 1): those where the matrix is at least so high; negative:
/// those where it is lower than -fade.
bool dithered(float fade) {
    if (fade >= 1.0)
        return false;
    float level = ditherLevel();
    return fade >= 0.0 ? level >= fade : level < -fade;
}
