// SPDX-License-Identifier: MIT
// One colour per tree, from 24 bits of its number, for a host that identifies the tree of a pixel.

#ifdef VERTEX_SHADER

flat out float hostTree;

void placeSurface(vec4 eye, vec3 normal, float tree) {
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
    hostTree = tree;
}

#else

flat in float hostTree;
out vec4 hostColor;

void paintSurface(vec3 color, vec3 albedo) {
    uint id = 1u + uint(hostTree * 16777214.0); // 0: no tree
    hostColor = vec4(vec3(id >> 16, id >> 8 & 255u, id & 255u) / 255.0, 1.0);
}

#endif
