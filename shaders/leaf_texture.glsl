// SPDX-License-Identifier: MIT
// Decodes the leaf texture (osgTreeWind/drawing/looks/LeafTexels.h).
// COVERAGE: draws the samples of a pixel that a leaf covers, under multisampling
// (osgTreeWind/drawing/looks/SceneShading.h). The pattern differs between cards, so that layers of leaves add up.
#pragma import_defines(COVERAGE)

#include "coverage.glsl"
#include "law/tint.glsl"

flat in int leafCard; // index of the card in the draw
uniform sampler2D leafTexture; // brightness, hue, alpha of bare twigs, alpha of leaves and twigs
uniform vec3 leafColor;
uniform vec3 twigColor;

/// @param texel brightness and hue. @param borne 1: leaves, 0: bare twigs.
vec3 leafAlbedo(vec2 texel, float borne) {
    return mix(twigColor, texelTint(texel.x, texel.y) * leafColor, borne);
}
float leafAlpha(vec4 texel, float borne) {
    return mix(texel.b, texel.a, borne);
}

/// Noise per card and block of 2 x 2 samples, independent of the motion of the card.
uint leafNoise(uvec2 block) {
    uint noise = block.x * 374761393u + block.y * 668265263u + uint(leafCard) * 2246822519u;
    noise = (noise ^ noise >> 13) * 1274126177u;
    return noise ^ noise >> 16;
}

/// Alpha threshold of a sample in a block. On average, a share of `alpha` of the samples is at or below alpha.
/// @param part column and row of the sample in the block, 0 or 1.
float leafThreshold(uint noise, ivec2 part) {
    ivec2 p = (part ^ ivec2(noise, noise >> 1)) & 1;
    return 0.25 * (float((p.x ^ p.y) << 1 | p.y) + float(noise >> 8) / 16777216.0);
}

/// Brightness and hue of a leaf or twig; discards uncovered pixels. @param borne as in leafAlbedo().
vec2 leafTexel(vec2 coord, float borne) {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 texels = fwidth(coord) * vec2(textureSize(leafTexture, 0));
    float sharper = 1.0 / clamp(max(texels.x, texels.y), 0.01, 1.0); // sharp edges if texels are larger than pixels
#ifdef COVERAGE
    uint noise = leafNoise(uvec2(pixel));
    vec2 across = 0.25 * dFdx(coord), along = 0.25 * dFdy(coord);
    vec3 sum = vec3(0.0);
    int covered = 0;
    for (int i = 0; i < 4; ++i) {
        ivec2 part = ivec2(i & 1, i >> 1);
        vec2 off = 2.0 * vec2(part) - 1.0;
        vec4 texel = texture(leafTexture, coord + off.x * across + off.y * along, -1.0);
        if (leafThreshold(noise, part) <= sharper * (leafAlpha(texel, borne) - 0.5) + 0.5) {
            sum += vec3(texel.rg, 1.0);
            covered |= 1 << i;
        }
    }
    drawSamples(covered);
    return sum.rg / sum.b;
#else
    vec4 texel = texture(leafTexture, coord);
    if (leafThreshold(leafNoise(uvec2(pixel >> 1)), pixel & 1) > sharper * (leafAlpha(texel, borne) - 0.5) + 0.5)
        discard;
    return texel.rg;
#endif
}
