// SPDX-License-Identifier: MIT
// Logarithmic depth, for a host that draws from centimetres to the horizon of a planet. The host's shaders write the same
// depth, and it sets the uniform on the root of the scene.

uniform float farthest; // metres

#ifdef VERTEX_SHADER

out float hostDistance;

void placeSurface(vec4 eye, vec3 normal, float tree) {
    gl_ClipVertex = eye;
    gl_Position = gl_ProjectionMatrix * eye;
    hostDistance = gl_Position.w;
}

#else

in float hostDistance;

void paintSurface(vec3 color, vec3 albedo) {
    gl_FragColor = vec4(color, 1.0);
    gl_FragDepth = log2(1.0 + hostDistance) / log2(1.0 + farthest);
}

#endif
