#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"
#include "leaf_texture.glsl"

uniform sampler2D leafTexture; // leaf_texture.glsl
uniform vec3 leafColor;

in vec2 leafCoord;
in vec3 leafLight;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord);
    if (leaf.a < 0.5) // LeafTexels::alphaThreshold
        discard;
    gl_FragColor = vec4(encoded(leafTint(leaf) * leafColor * leafLight), 1.0);
}
