// SPDX-License-Identifier: MIT

#pragma import_defines(COVERAGE, FADING, TIERS_COLORED)

#if defined(FADING) && defined(TIERS_COLORED)
flat in vec3 treeTierColor;
#define tierColor treeTierColor
#endif

#include "leaf_texture.glsl"
#include "scene.glsl"
#include "surface.glsl"

in vec2 leafCoord;
in vec3 leafLight;
in vec3 scenePosition;
flat in float treeFade;
flat in float leafBorne;

void main() {
    vec2 leaf = leafTexel(leafCoord, leafBorne); // before the discard below, as it uses derivatives
#ifdef FADING
    if (dithered(treeFade))
        discard;
#endif
    vec3 albedo = leafAlbedo(leaf, leafBorne);
    paintSurface(sceneColor(albedo * shadowed(leafLight, sunLight, scenePosition), scenePosition), albedo);
}
