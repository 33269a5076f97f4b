// SPDX-License-Identifier: MIT
// What a texel of a leaf texture means (osgTreeWind/drawing/looks/LeafTexels.h).

// COVERAGE: alpha is what of a pixel is covered, under multisampling (osgTreeWind/drawing/looks/SceneShading.h).
#pragma import_defines(COVERAGE)

#include "law/tint.glsl"

flat in int leafCard; // its number among all of the draw
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

/// Differs from card to card and from block to block of 2 x 2 samples, and stays as the card moves.
uint leafNoise(uvec2 block) {
    uint noise = block.x * 374761393u + block.y * 668265263u + uint(leafCard) * 2246822519u;
    noise = (noise ^ noise >> 13) * 1274126177u;
    return noise ^ noise >> 16;
}

/// Of the samples of a block as many are at or below a card's alpha as it covers, in the mean.
/// @param part which of them, 0 or 1 both ways.
float leafThreshold(uint noise, ivec2 part) {
    ivec2 p = (part ^ ivec2(noise, noise >> 1)) & 1;
    return 0.25 * (float((p.x ^ p.y) << 1 | p.y) + float(noise >> 8) / 16777216.0);
}

/// The texel of a place, whose alpha is there or not; under COVERAGE the mean of four in its pixel.
vec4 leafTexel(vec2 coord) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 texels = fwidth(coord) * vec2(textureSize(leafTexture, 0));
    float sharper = 1.0 / clamp(max(texels.x, texels.y), 0.01, 1.0); // close by edges are of a pixel, not of a texel
#ifdef COVERAGE
    uint noise = leafNoise(uvec2(pixel));
    vec2 across = 0.25 * dFdx(coord), along = 0.25 * dFdy(coord);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 part = ivec2(i & 1, i >> 1);
        vec2 off = 2.0 * vec2(part) - 1.0;
        vec4 texel = texture(leafTexture, coord + off.x * across + off.y * along, -1.0);
        sum += vec4(texel.rg, step(leafThreshold(noise, part), sharper * (texel.ba - 0.5) + 0.5));
    }
    return 0.25 * sum;
#else
    vec4 texel = texture(leafTexture, coord);
    return vec4(texel.rg, step(leafThreshold(leafNoise(uvec2(pixel >> 1)), pixel & 1), sharper * (texel.ba - 0.5) + 0.5));
#endif
}

/// Alpha to write for one of leafAlpha(); what is not drawn is discarded.
float leafCoverage(float alpha) {
    if (alpha <= 0.0)
        discard;
    return alpha;
}
