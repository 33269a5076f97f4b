// SPDX-License-Identifier: MIT
// A colour a tree, 24 bits of its own number, for a host that wants to know which tree each pixel shows.

#ifdef VERTEX_SHADER

flat out float hostTree;

void placeSurface(vec4 eye, vec3 normal, float tree) {
    gl_ClipVertex = eye;
    gl_Position = gl_ProjectionMatrix * eye;
    hostTree = tree;
}

#else

flat in float hostTree;

void paintSurface(vec3 color, vec3 albedo) {
    uint id = 1u + uint(hostTree * 16777214.0); // 0 is where no tree is
    gl_FragColor = vec4(vec3(id >> 16, id >> 8 & 255u, id & 255u) / 255.0, 1.0);
}

#endif
