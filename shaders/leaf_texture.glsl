// SPDX-License-Identifier: MIT
// What a texel of a leaf texture means (osgTreeWind/nodes/LeafTexels.h).

uniform sampler2D leafTexture; // brightness, hue, alpha of bare twigs, alpha of leaves and twigs
uniform vec3 leafColor;
uniform vec3 twigColor;

/// What leaves reflect over the colour of the species' leaves: brightness, with a hue from bluish to yellowish.
vec3 leafTexelTint(vec4 texel) {
    return texel.r * (1.0 + (texel.g - 0.5) * vec3(0.5, 0.1, -0.4));
}

/// @param borne 1; 0: bare twigs.
vec3 leafAlbedo(vec4 texel, float borne) {
    return mix(twigColor, leafTexelTint(texel) * leafColor, borne);
}
float leafAlpha(vec4 texel, float borne) {
    return mix(texel.b, texel.a, borne);
}
