// SPDX-License-Identifier: MIT
out vec2 spot;
void main() {
    spot = osg_MultiTexCoord0.xy;
    vec4 place = osg_ProjectionMatrix * vec4(mat3(osg_ModelViewMatrix) * osg_Vertex.xyz, 0.0);
    gl_Position = vec4(place.xy, 0.99999 * place.w, place.w);
}
