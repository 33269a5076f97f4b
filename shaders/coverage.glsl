// SPDX-License-Identifier: MIT
// Partial coverage of a pixel without blending. COVERAGE: a share of the pixel's samples is drawn, under multisampling
// (osgTreeWind/drawing/looks/SceneShading.h); otherwise the pixel is drawn or discarded.
#pragma import_defines(COVERAGE)

#ifdef COVERAGE
/// Draws some of a pixel's samples, or none. @param covered a bit for each of four samples, repeated for more samples.
void drawSamples(int covered) {
    if (covered == 0)
        discard;
    gl_SampleMask[0] = 0x11111111 * covered;
}
#endif

/// @param share of the pixel, [0, 1]. @param chance uniform in [0, 1), different in neighbouring pixels.
void cover(float share, float chance) {
#ifdef COVERAGE
    int covered = 0;
    for (int i = 0; i < 4; ++i)
        if (fract(chance + 0.25 * float(i)) < share)
            covered |= 1 << i;
    drawSamples(covered);
#else
    if (share <= chance)
        discard;
#endif
}
