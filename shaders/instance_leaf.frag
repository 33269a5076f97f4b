#version 330 compatibility
// SPDX-License-Identifier: MIT

// LEAF_TEXTURE_BIAS: of enlarged clusters (model/TreeDetail.h).
#pragma import_defines(FADING, LEAF_TEXTURE_BIAS)

#include "dither.glsl"
#include "leaf_texture.glsl"
#include "scene.glsl"
#include "surface.glsl"

in vec2 leafCoord;
in vec3 leafLight;
in vec3 scenePosition;
flat in float treeFade;
flat in float leafBorne;

void main() {
#ifdef LEAF_TEXTURE_BIAS
    vec4 leaf = texture(leafTexture, leafCoord, LEAF_TEXTURE_BIAS);
#else
    vec4 leaf = texture(leafTexture, leafCoord);
#endif
    float coverage = leafCoverage(leafAlpha(leaf, leafBorne));
#ifdef FADING
    if (dithered(treeFade))
        discard;
#endif
    vec3 albedo = leafAlbedo(leaf, leafBorne);
    paintSurface(sceneColor(albedo * shadowed(leafLight, sunLight, scenePosition), scenePosition), albedo, coverage);
}
