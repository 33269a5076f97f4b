#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "bark_texture.glsl"
#include "encode.glsl"
#include "surface.glsl"

in vec3 barkCoord;
in float barkRadius;
in vec3 barkLight;

void main() {
    float inside = gl_FrontFacing ? 1.0 : 0.4;
    vec3 albedo = inside * barkAlbedo(coordOnBark(barkCoord), barkRadius);
    paintSurface(encoded(albedo * barkLight), albedo);
}
