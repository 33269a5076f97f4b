// SPDX-License-Identifier: MIT
// What a texel of a leaf texture means (osgTreeWind/drawing/looks/LeafTexels.h).

// COVERAGE: alpha is what of a pixel is covered, under multisampling (osgTreeWind/drawing/looks/SceneShading.h).
#pragma import_defines(COVERAGE)

#include "law/tint.glsl"

uniform sampler2D leafTexture; // brightness, hue, alpha of bare twigs, alpha of leaves and twigs
uniform vec3 leafColor;
uniform vec3 twigColor;

/// @param borne 1; 0: bare twigs.
vec3 leafAlbedo(vec4 texel, float borne) {
    return mix(twigColor, texelTint(texel.r, texel.g) * leafColor, borne);
}
float leafAlpha(vec4 texel, float borne) {
    return mix(texel.b, texel.a, borne);
}

/// Alpha to write for one of leafAlpha(); what is not drawn is discarded.
float leafCoverage(float alpha) {
#ifdef COVERAGE
    float covered = (alpha - 0.5) / max(fwidth(alpha), 1.0e-4) + 0.5; // a sharp edge at 0.5, a pixel wide
    if (covered <= 0.0)
        discard;
    return min(covered, 1.0);
#else
    if (alpha < 0.5) // LeafTexels::alphaThreshold
        discard;
    return 1.0;
#endif
}
