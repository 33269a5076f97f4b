// SPDX-License-Identifier: MIT

#pragma import_defines(COVERAGE, FADING, TIERS_COLORED)

#if defined(FADING) && defined(TIERS_COLORED)
flat in vec3 treeTierColor;
#define tierColor treeTierColor
#endif

#include "bark_texture.glsl"
#include "coverage.glsl"
#include "dither.glsl"
#include "scene.glsl"
#include "surface.glsl"

in vec3 barkCoord;
in vec2 barkGirth;
in float barkCover; // share of its pixels that thin wood covers
in vec3 barkLight;
in vec3 scenePosition;
flat in float treeFade;

void main() {
#ifdef FADING
    if (dithered(treeFade))
        discard;
#endif
    float inside = gl_FrontFacing ? 1.0 : 0.4;
    vec3 albedo = inside * barkAlbedo(coordOnBark(barkCoord), barkGirth);
    if (barkCover < 0.99)
        cover(barkCover, evenNoise());
#ifdef COVERAGE
    else
        gl_SampleMask[0] = -1;
#endif
    paintSurface(sceneColor(albedo * shadowed(barkLight, sunLight, scenePosition), scenePosition), albedo);
}
