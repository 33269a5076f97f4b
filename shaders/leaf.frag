#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"
#include "leaf_texture.glsl"

in vec2 leafCoord;
in vec3 leafLight;
flat in float leafBorne;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord);
    float coverage = leafCoverage(leafAlpha(leaf, leafBorne));
    gl_FragColor = vec4(encoded(leafAlbedo(leaf, leafBorne) * leafLight), coverage);
}
