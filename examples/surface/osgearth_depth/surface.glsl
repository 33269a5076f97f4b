// SPDX-License-Identifier: MIT
// The depth of osgEarth's LogarithmicDepthBuffer, in its default variant (setUseFragDepth(false)).

#ifdef VERTEX_SHADER

void placeSurface(vec4 eye, vec3 normal, float tree) {
    clipSurface(eye);
    gl_Position = osg_ProjectionMatrix * eye;
    if (osg_ProjectionMatrix[3][3] == 0.0) { // perspective; shadow cameras are orthographic
        vec4 far = inverse(osg_ProjectionMatrix) * vec4(0.0, 0.0, 1.0, 1.0); // computed as in osgEarth, to the last bit
        float farthest = -far.z / far.w;
        float scale = 2.0 / log2(farthest + 1.0);
        gl_Position.z = (log2(max(1e-6, gl_Position.w + 1.0)) * scale - 1.0) * gl_Position.w;
    }
}

#else

out vec4 hostColor;

void paintSurface(vec3 color, vec3 albedo) {
    hostColor = vec4(color, 1.0);
}

#endif
