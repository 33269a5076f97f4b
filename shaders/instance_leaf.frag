#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "dither.glsl"
#include "scene.glsl"

uniform sampler2D leafTexture; // colour variation, alpha: shape
uniform vec3 leafColor;

in vec2 leafCoord;
in vec3 leafLight;
in vec3 scenePosition;
flat in float treeFade;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord);
    if (leaf.a < 0.5 || dithered(treeFade)) // leafAlphaThreshold of TreeTextures.cpp
        discard;
    gl_FragColor = vec4(sceneColor(leaf.rgb * leafColor * leafLight, scenePosition), 1.0);
}
