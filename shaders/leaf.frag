#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"
#include "leaf_texture.glsl"
#include "surface.glsl"

in vec2 leafCoord;
in vec3 leafLight;
flat in float leafBorne;

void main() {
    vec3 albedo = leafAlbedo(leafTexel(leafCoord, leafBorne), leafBorne);
    paintSurface(encoded(albedo * leafLight), albedo);
}
