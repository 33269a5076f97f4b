#version 330 compatibility
// SPDX-License-Identifier: MIT
// A quad over the whole target of a pass, with one fragment per texel.

void main() {
    gl_Position = vec4(gl_Vertex.xy, 0.0, 1.0);
}
