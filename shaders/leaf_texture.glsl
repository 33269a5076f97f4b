// SPDX-License-Identifier: MIT
// What a texel of a leaf texture means (osgTreeWind/nodes/LeafTexels.h).

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
