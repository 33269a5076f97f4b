#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"

uniform sampler2D leafTexture; // colour variation, alpha: shape
uniform vec3 leafColor;

in vec2 leafCoord;
in vec3 leafLight;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord);
    if (leaf.a < 0.5) // leafAlphaThreshold of TreeTextures.cpp
        discard;
    gl_FragColor = vec4(encoded(leaf.rgb * leafColor * leafLight), 1.0);
}
