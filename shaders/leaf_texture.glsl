// SPDX-License-Identifier: MIT
// Decodes the leaf texture (osgTreeWind/drawing/looks/LeafTexels.h).
// COVERAGE: draws the samples of a pixel that a leaf covers, under multisampling
// (osgTreeWind/drawing/looks/SceneShading.h). The pattern differs between cards, so that layers of leaves add up.
#pragma import_defines(COVERAGE)

#include "coverage.glsl"
#include "dither.glsl"
#include "law/tint.glsl"

flat in int leafCard; // number of the card in the tree
in vec2 leafFacing;   // facing.glsl
uniform sampler2D leafTexture; // brightness, hue, alpha of bare twigs, alpha of leaves and twigs
uniform vec3 leafColor;
uniform vec3 twigColor;

/// @param texel brightness and hue. @param borne 1: leaves, 0: bare twigs.
vec3 leafAlbedo(vec2 texel, float borne) {
    return mix(twigColor, texelTint(texel.x, texel.y) * leafColor, borne);
}
float leafAlpha(vec4 texel, float borne) {
    return leafFacing.x * mix(texel.b, texel.a, borne);
}

/// Alpha threshold of a sample of the pixel: four samples have one in each quarter of [0, 1), so that a share of
/// `alpha` of the samples is at or below alpha, and that share is as even as possible over neighbouring pixels.
/// @param chance of the pixel and card, [0, 1). @param part column and row of the sample, 0 or 1.
float leafThreshold(float chance, ivec2 part) {
    int turn = int(16.0 * chance);
    ivec2 p = (part ^ ivec2(turn, turn >> 1)) & 1;
    return 0.25 * (float((p.x ^ p.y) << 1 | p.y) + chance);
}

/// Brightness and hue of a leaf or twig; discards uncovered pixels. @param borne as in leafAlbedo().
vec2 leafTexel(vec2 coord, float borne) {
    float chance = fract(evenNoise() + 0.618034 * float(leafCard & 1023)); // differs between cards, so that layers add up
    vec2 texels = fwidth(coord) * vec2(textureSize(leafTexture, 0));
    float sharper = 1.0 / clamp(max(texels.x, texels.y), 0.01, 1.0); // sharp edges if texels are larger than pixels
#ifdef COVERAGE
    vec2 across = 0.25 * dFdx(coord), along = 0.25 * dFdy(coord);
    vec3 sum = vec3(0.0);
    int covered = 0;
    for (int i = 0; i < 4; ++i) {
        ivec2 part = ivec2(i & 1, i >> 1);
        vec2 off = 2.0 * vec2(part) - 1.0;
        vec4 texel = texture(leafTexture, coord + off.x * across + off.y * along, leafFacing.y - 1.0);
        if (leafThreshold(chance, part) <= sharper * (leafAlpha(texel, borne) - 0.5) + 0.5) {
            sum += vec3(texel.rg, 1.0);
            covered |= 1 << i;
        }
    }
    drawSamples(covered);
    return sum.rg / sum.b;
#else
    vec4 texel = texture(leafTexture, coord, leafFacing.y);
    if (chance >= sharper * (leafAlpha(texel, borne) - 0.5) + 0.5)
        discard;
    return texel.rg;
#endif
}
