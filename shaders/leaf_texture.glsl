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

/// The texel of a place; under COVERAGE the mean of four in its pixel, whose alpha is there or not.
vec4 leafTexel(vec2 coord) {
#ifdef COVERAGE
    vec2 across = 0.25 * dFdx(coord), along = 0.25 * dFdy(coord);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        vec2 place = coord + ((i & 1) == 0 ? across : -across) + ((i & 2) == 0 ? along : -along);
        vec4 texel = texture(leafTexture, place, -1.0);
        sum += vec4(texel.rg, step(0.5, texel.ba));
    }
    return 0.25 * sum;
#else
    return texture(leafTexture, coord);
#endif
}

/// Alpha to write for one of leafAlpha(); what is not drawn is discarded.
float leafCoverage(float alpha) {
#ifdef COVERAGE
    if (alpha <= 0.0)
        discard;
    return alpha;
#else
    if (alpha < 0.5) // LeafTexels::alphaThreshold
        discard;
    return 1.0;
#endif
}
