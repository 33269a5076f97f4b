#version 330 compatibility
// SPDX-License-Identifier: MIT

#include "encode.glsl"

uniform sampler2D barkTexture; // grey
uniform vec3 barkColor;

in vec2 barkCoord;
in vec3 barkLight;

void main() {
    float shade = texture(barkTexture, barkCoord).r;
    float inside = gl_FrontFacing ? 1.0 : 0.4;
    gl_FragColor = vec4(encoded(inside * shade * barkColor * barkLight), 1.0);
}
