// SPDX-License-Identifier: MIT
// The state of OpenGL by the names that the shaders use, in a compatibility profile. It precedes each shader there.

#ifdef VERTEX_SHADER
#define osg_Vertex gl_Vertex
#define osg_Normal gl_Normal
#define osg_MultiTexCoord0 gl_MultiTexCoord0
#define osg_MultiTexCoord1 gl_MultiTexCoord1
#define osg_MultiTexCoord2 gl_MultiTexCoord2
#define osg_MultiTexCoord3 gl_MultiTexCoord3
#define osg_Color gl_Color
#define osg_ModelViewMatrix gl_ModelViewMatrix
#define osg_ProjectionMatrix gl_ProjectionMatrix
#define osg_NormalMatrix gl_NormalMatrix
#define clipSurface(eye) gl_ClipVertex = eye
#endif

#define osg_LightSource gl_LightSource
#define sceneAmbient gl_LightModel.ambient
#define sceneFog gl_Fog
#define shadowPlace(unit, eye) vec4(dot(gl_EyePlaneS[unit], eye), dot(gl_EyePlaneT[unit], eye), \
                                    dot(gl_EyePlaneR[unit], eye), dot(gl_EyePlaneQ[unit], eye))
