// SPDX-License-Identifier: MIT
// Where every vertex and every pixel of a tree leaves these shaders. A host that draws into something of its own, with
// logarithmic depth, a G-buffer or ids of objects, puts a file of this name into a folder of OSG_FILE_PATH (docs/hosts.md).

#ifdef VERTEX_SHADER

/// The last that is done to a vertex.
/// eye: where it is, from the eye. normal: of unit length, in eye space; of a picture of a tree, toward the eye.
/// tree: the tree's own number, [0, 1).
void placeSurface(vec4 eye, vec3 normal, float tree) {
    gl_ClipVertex = eye;
    gl_Position = gl_ProjectionMatrix * eye;
}

#else

/// The last that is done to a pixel.
/// color: as it is seen, lit, in fog and encoded. albedo: linear, without light.
void paintSurface(vec3 color, vec3 albedo) {
    gl_FragColor = vec4(color, 1.0);
}

#endif
