// SPDX-License-Identifier: MIT
// Logarithmic depth, for a host that draws from centimetres to the horizon of a planet. The host's shaders write the same
// depth, and it sets the uniform on the root of the scene.

uniform float farthest; // metres

#ifdef VERTEX_SHADER

out float hostDistance;

void placeSurface(vec4 eye, vec3 normal, float tree) {
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
    hostDistance = gl_Position.w;
}

#else

in float hostDistance;
out vec4 hostColor;

void paintSurface(vec3 color, vec3 albedo) {
    hostColor = vec4(color, 1.0);
    gl_FragDepth = log2(1.0 + hostDistance) / log2(1.0 + farthest);
}

#endif
