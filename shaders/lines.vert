// SPDX-License-Identifier: MIT
// Coloured lines, for a core profile.

out vec4 vertexColor;

void main() {
    vertexColor = osg_Color;
    vec4 eye = osg_ModelViewMatrix * osg_Vertex;
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
}
