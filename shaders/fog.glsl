// SPDX-License-Identifier: MIT
// FOG_MODE: 1 linear, 2 exponential, 3 exponential squared (osgTreeWind/drawing/looks/SceneShading.h).
#pragma import_defines(FOG_MODE)

/// Share of the fragment's colour in OpenGL's fog.
float fogLeft(vec3 eyePosition) {
#ifdef FOG_MODE
    float far = abs(eyePosition.z);
#if FOG_MODE == 1
    return clamp((sceneFog.end - far) * sceneFog.scale, 0.0, 1.0);
#elif FOG_MODE == 2
    return clamp(exp(-sceneFog.density * far), 0.0, 1.0);
#else
    return clamp(exp(-sceneFog.density * far * sceneFog.density * far), 0.0, 1.0);
#endif
#else
    return 1.0;
#endif
}
