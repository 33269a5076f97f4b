// SPDX-License-Identifier: MIT
// Encodes linear colours for output. ENCODED_BY_OPENGL: no encoding, for scenes with GL_FRAMEBUFFER_SRGB
// (osgTreeWind/drawing/looks/SceneShading.h). LINEAR_COLORS: the same, for scenes with their own exposure and encoding.
// FILM: exposure of a filmic tone curve before the encoding, set by `render` and `view`; undefined: no tone curve, but
// a factor EXPOSURE. Its default shows sunlit leaves as a photograph does under a white light of .8, as in osgviewer.
#pragma import_defines(ENCODED_BY_OPENGL, EXPOSURE, FILM, LINEAR_COLORS)

#ifndef EXPOSURE
#ifdef LINEAR_COLORS
#define EXPOSURE 1.0
#else
#define EXPOSURE 3.0
#endif
#endif

const vec3 luminanceWeights = vec3(0.2126, 0.7152, 0.0722); // Rec. 709

#ifdef FILM
/// Narkowicz 2016, ACES Filmic Tone Mapping Curve. Colours are desaturated before, as the curve saturates them.
vec3 filmed(vec3 color) {
    vec3 c = FILM * mix(vec3(dot(color, luminanceWeights)), color, 0.86);
    return c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14);
}
#else
vec3 filmed(vec3 color) { return EXPOSURE * color; }
#endif

/// sRGB encoding within 0.0004 of IEC 61966-2-1, by square roots, which are faster than powers.
vec3 encoded(vec3 color) {
#if defined(LINEAR_COLORS) || defined(ENCODED_BY_OPENGL)
    return filmed(color);
#else
    vec3 c = clamp(filmed(color), 0.0, 1.0);
    vec3 root = sqrt(c);
    vec3 bright = 0.833744 * root + 0.298113 * sqrt(root) - 0.055312 * c - 0.076904;
    return mix(12.92 * c, bright, step(0.0031308, c));
#endif
}
