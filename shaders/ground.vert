// SPDX-License-Identifier: MIT
// The ground without a look of the host, for a core profile: white and lit, as OpenGL draws it in a compatibility
// profile.

out vec4 vertexColor;

void main() {
    vec4 eye = osg_ModelViewMatrix * osg_Vertex;
    vec4 sun = osg_LightSource[0].position;
    vec3 toSun = normalize(sun.xyz - sun.w * eye.xyz);
    float facing = max(dot(normalize(osg_NormalMatrix * osg_Normal), toSun), 0.0);
    vertexColor = vec4(sceneAmbient.rgb + osg_LightSource[0].ambient.rgb + facing * osg_LightSource[0].diffuse.rgb, 1.0);
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
}
