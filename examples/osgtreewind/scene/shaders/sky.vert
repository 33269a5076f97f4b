#version 330 compatibility
// SPDX-License-Identifier: MIT
out vec2 spot;
void main() {
    spot = gl_MultiTexCoord0.xy;
    vec4 place = gl_ProjectionMatrix * vec4(mat3(gl_ModelViewMatrix) * gl_Vertex.xyz, 0.0);
    gl_Position = vec4(place.xy, 0.99999 * place.w, place.w);
}
