// SPDX-License-Identifier: MIT
// The last functions for every vertex and pixel of trees. A host with logarithmic depth, a G-buffer or object ids
// replaces them: it puts a file of this name into a folder of OSG_FILE_PATH (docs/hosts.md).

#ifdef VERTEX_SHADER

/// The end of each vertex shader.
/// eye: position in eye space. normal: unit normal in eye space, toward the eye for impostors.
/// tree: number of the tree, [0, 1).
void placeSurface(vec4 eye, vec3 normal, float tree) {
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
}

#else

/// The end of each fragment shader.
/// color: final colour, lit, encoded and in fog. albedo: linear, without light.
out vec4 surfaceColor;

void paintSurface(vec3 color, vec3 albedo) {
    surfaceColor = vec4(color, 1.0);
}

#endif
