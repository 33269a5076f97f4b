#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"
#include "leaf_texture.glsl"

in vec2 leafCoord;
in vec3 leafLight;
flat in float leafBorne;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord);
    if (leafAlpha(leaf, leafBorne) < 0.5) // LeafTexels::alphaThreshold
        discard;
    gl_FragColor = vec4(encoded(leafAlbedo(leaf, leafBorne) * leafLight), 1.0);
}
