#version 330 compatibility
// SPDX-License-Identifier: MIT

#pragma import_defines(FADING)

#include "dither.glsl"
#include "scene.glsl"

uniform sampler2D leafTexture; // colour variation, alpha: shape
uniform vec3 leafColor;
uniform float leafTextureBias; // of enlarged clusters (model/TreeDetail.h)

in vec2 leafCoord;
in vec3 leafLight;
in vec3 scenePosition;
flat in float treeFade;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord, leafTextureBias);
    if (leaf.a < 0.5) // leafAlphaThreshold of TreeTextures.cpp
        discard;
#ifdef FADING
    if (dithered(treeFade))
        discard;
#endif
    gl_FragColor = vec4(sceneColor(leaf.rgb * leafColor * leafLight, scenePosition), 1.0);
}
