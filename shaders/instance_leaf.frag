#version 330 compatibility
// SPDX-License-Identifier: MIT

// LEAF_TEXTURE_BIAS: of enlarged clusters (model/TreeDetail.h).
#pragma import_defines(FADING, LEAF_TEXTURE_BIAS)

#include "dither.glsl"
#include "leaf_texture.glsl"
#include "scene.glsl"

uniform sampler2D leafTexture; // leaf_texture.glsl
uniform vec3 leafColor;

in vec2 leafCoord;
in vec3 leafLight;
in vec3 scenePosition;
flat in float treeFade;

void main() {
#ifdef LEAF_TEXTURE_BIAS
    vec4 leaf = texture(leafTexture, leafCoord, LEAF_TEXTURE_BIAS);
#else
    vec4 leaf = texture(leafTexture, leafCoord);
#endif
    if (leaf.a < 0.5) // LeafTexels::alphaThreshold
        discard;
#ifdef FADING
    if (dithered(treeFade))
        discard;
#endif
    gl_FragColor = vec4(sceneColor(leafTint(leaf) * leafColor * leafLight, scenePosition), 1.0);
}
