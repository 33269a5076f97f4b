// SPDX-License-Identifier: MIT
// What a texel of bark means (osgTreeWind/drawing/looks/BarkRelief.h).
#pragma import_defines(LIGHT_MASK, UNLIT)

#include "law/tint.glsl"

uniform sampler2D barkTexture; // brightness, height, hue
uniform vec3 barkColor;

/// What light 0 makes of the relief: slopes toward it are brighter. Slopes are found on the screen, with no tangents.
float barkRelief(float height, vec2 coord) {
#if defined(UNLIT) || (defined(LIGHT_MASK) && !(LIGHT_MASK & 1))
    return 1.0;
#else
    vec2 across = dFdx(coord), along = dFdy(coord);
    float pixel = sqrt(0.5 * (dot(across, across) + dot(along, along))) + 1.0e-6; // in widths of the bark
    vec2 slope = vec2(dFdx(height), dFdy(height)) / pixel;
    vec2 toLight = normalize(gl_LightSource[0].position.xyz).xy;
    return 1.0 - clamp(0.04 * dot(slope, toLight), -0.5, 0.5);
#endif
}

/// What bark reflects.
vec3 barkAlbedo(vec2 coord) {
    vec3 texel = texture(barkTexture, coord).rgb;
    return barkRelief(texel.g, coord) * texelTint(texel.r, texel.b) * barkColor;
}
