// SPDX-License-Identifier: MIT
// The state of OSG and of the scene, in a core profile. It precedes each shader there. OSG sets the attributes and
// matrices, osgTreeWind/drawing/looks/SceneUniforms.cpp the rest; a host may set osg_LightSource.
// CLIP_PLANES: number of clip planes (osgTreeWind/drawing/looks/SceneShading.h).
#pragma import_defines(CLIP_PLANES)

#ifdef VERTEX_SHADER
in vec4 osg_Vertex;
in vec3 osg_Normal;
in vec4 osg_Color;
in vec4 osg_MultiTexCoord0;
in vec4 osg_MultiTexCoord1;
in vec4 osg_MultiTexCoord2;
in vec4 osg_MultiTexCoord3;
uniform mat4 osg_ModelViewMatrix;
uniform mat4 osg_ProjectionMatrix;
uniform mat3 osg_NormalMatrix;

#ifdef CLIP_PLANES
uniform vec4 sceneClipPlanes[CLIP_PLANES]; // in eye space
out float gl_ClipDistance[CLIP_PLANES];
#endif

/// Applies the clip planes of the scene to a vertex. @param eye in eye space.
void clipSurface(vec4 eye) {
#ifdef CLIP_PLANES
    for (int i = 0; i < CLIP_PLANES; ++i)
        gl_ClipDistance[i] = dot(sceneClipPlanes[i], eye);
#endif
}
#endif

struct LightSource {
    vec4 ambient;
    vec4 diffuse;
    vec4 position; // in eye space
    vec3 spotDirection;
    float spotExponent;
    float spotCutoff; // degrees
    float constantAttenuation;
    float linearAttenuation;
    float quadraticAttenuation;
};
uniform LightSource osg_LightSource[8];
uniform vec4 sceneAmbient;

struct Fog {
    vec4 color;
    float density;
    float end;
    float scale; // 1 / (end - start)
};
uniform Fog sceneFog;

uniform mat4 sceneEyePlanes[16]; // by texture unit

/// Coordinates in the shadow texture of a unit. @param eye in eye space.
vec4 shadowPlace(int unit, vec4 eye) { return sceneEyePlanes[unit] * eye; }
