// SPDX-License-Identifier: MIT
// Albedo and normals, for a host with deferred lighting.

#ifdef VERTEX_SHADER

out vec3 hostNormal;

void placeSurface(vec4 eye, vec3 normal, float tree) {
    gl_ClipVertex = eye;
    gl_Position = gl_ProjectionMatrix * eye;
    hostNormal = normal;
}

#else

in vec3 hostNormal;

void paintSurface(vec3 color, vec3 albedo) {
    gl_FragData[0] = vec4(albedo, 1.0);
    gl_FragData[1] = vec4(normalize(hostNormal), 1.0);
}

#endif
