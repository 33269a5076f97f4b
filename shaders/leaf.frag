#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"
#include "leaf_texture.glsl"
#include "surface.glsl"

in vec2 leafCoord;
in vec3 leafLight;
flat in float leafBorne;

void main() {
    vec4 leaf = leafTexel(leafCoord);
    float coverage = leafCoverage(leafAlpha(leaf, leafBorne));
    vec3 albedo = leafAlbedo(leaf, leafBorne);
    paintSurface(encoded(albedo * leafLight), albedo, coverage);
}
