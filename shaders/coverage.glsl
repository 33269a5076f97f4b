// SPDX-License-Identifier: MIT
// A share of a pixel that is covered, without blending. COVERAGE: under multisampling it is a share of the pixel's samples
// (osgTreeWind/drawing/looks/SceneShading.h); else the pixel is drawn or not.
#pragma import_defines(COVERAGE)

#ifdef COVERAGE
/// Draws some of a pixel's samples, or nothing.
/// @param covered a bit for each of four; of more than four samples each fourth goes with one.
void drawSamples(int covered) {
    if (covered == 0)
        discard;
    gl_SampleMask[0] = 0x11111111 * covered;
}
#endif

/// @param share [0, 1]. @param chance even in [0, 1); pixels next to each other differ.
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
