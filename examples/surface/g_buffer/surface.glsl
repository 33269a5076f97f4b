// SPDX-License-Identifier: MIT
// Albedo and normals, for a host with deferred lighting.

#ifdef VERTEX_SHADER

out vec3 hostNormal;

void placeSurface(vec4 eye, vec3 normal, float tree) {
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
    hostNormal = normal;
}

#else

in vec3 hostNormal;
layout(location = 0) out vec4 hostAlbedo;
layout(location = 1) out vec4 hostNormals;

void paintSurface(vec3 color, vec3 albedo) {
    hostAlbedo = vec4(albedo, 1.0);
    hostNormals = vec4(normalize(hostNormal), 1.0);
}

#endif
