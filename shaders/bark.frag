#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "bark_texture.glsl"
#include "encode.glsl"

in vec2 barkCoord;
in vec3 barkLight;

void main() {
    float inside = gl_FrontFacing ? 1.0 : 0.4;
    gl_FragColor = vec4(encoded(inside * barkAlbedo(barkCoord) * barkLight), 1.0);
}
