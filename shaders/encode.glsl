// SPDX-License-Identifier: MIT
// Colours are linear until they are written. LINEAR_COLORS: they stay so, where the scene has GL_FRAMEBUFFER_SRGB on or
// encodes by itself (osgTreeWind/drawing/looks/SceneShading.h).
#pragma import_defines(LINEAR_COLORS)

/// As sRGB, within 0.0004: IEC 61966-2-1 by roots, which are quicker than powers.
vec3 encoded(vec3 color) {
#ifdef LINEAR_COLORS
    return color;
#else
    vec3 c = clamp(color, 0.0, 1.0);
    vec3 root = sqrt(c);
    vec3 bright = 0.833744 * root + 0.298113 * sqrt(root) - 0.055312 * c - 0.076904;
    return mix(12.92 * c, bright, step(0.0031308, c));
#endif
}
