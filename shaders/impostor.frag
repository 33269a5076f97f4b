// SPDX-License-Identifier: MIT
// Selects one of the four nearest pictures and one of two mipmaps per pixel, at random by their interpolation weights,
// and draws the pixel (under multisampling each sample) with the probability of its coverage. Without blending, the
// order of the trees does not matter.

#pragma import_defines(COVERAGE, FADING)

#include "coverage.glsl"
#include "dither.glsl"
#include "scene.glsl"
#include "surface.glsl"

uniform sampler2D impostorColors;  // premultiplied by coverage, which is alpha
uniform sampler2D impostorNormals; // premultiplied: mean normal of LightLobe; 1 for leaves, 0 for bark
uniform vec4 impostorSize;
uniform vec3 leafTint; // leaf colour of the season, over the painted colour

flat in vec4 pictureViews;
flat in vec4 pictureParts;
flat in vec3 barkLight;
flat in vec3 leafLightMore;
flat in mat3 lightByNormal;
#ifdef SHADOWED
flat in vec3 pictureSunScattering;
flat in vec3 pictureSunWay;
in vec3 pictureFront;
#else
#define pictureFront pictureEye
#endif
in vec2 pictureCoord;
in float pictureLeft;
in vec3 pictureEye;

/// Whether `chance` is below `share`. Rescales `chance` to be uniform in [0, 1) again.
bool drawn(inout float chance, float share) {
    bool below = chance < share;
    chance = below ? chance / share : (chance - share) / (1.0 - share);
    return below;
}

void main() {
    vec2 texels = pictureCoord * (vec2(textureSize(impostorColors, 0)) / impostorSize.zw);
    vec2 dx = dFdx(texels);
    vec2 dy = dFdy(texels);
#ifdef FADING
    if (dithered(pictureParts.z))
        discard;
#endif

    float chance = fract(evenNoise() + pictureParts.w); // differs between trees, so that layers add up
    float column = drawn(chance, pictureParts.x) ? pictureViews.y : pictureViews.x;
    float row = drawn(chance, pictureParts.y) ? pictureViews.w : pictureViews.z;
    vec2 coord = (vec2(column, row) + pictureCoord) / impostorSize.zw;
    float coarsest = log2(float(textureSize(impostorColors, 0).x) / impostorSize.z) - 3.0; // keeps pictures separate
    float lod = clamp(0.5 * log2(max(dot(dx, dx), dot(dy, dy))), 0.0, coarsest);
    lod = floor(lod + fract(64.0 * chance)); // one mipmap only: half of the texels
    vec4 color = textureLod(impostorColors, coord, lod);
    cover(color.a, chance);

    vec4 lobe = textureLod(impostorNormals, coord, lod) / color.a;
    vec3 way = 4.0 * lobe.xyz - 2.0;
    vec3 light = barkLight + lobe.a * leafLightMore + lightByNormal * way;
    vec3 sun = sunLight;
#ifdef SHADOWED
    sun *= 0.25 + lobe.a * pictureSunScattering + 0.5 * dot(pictureSunWay, way);
    light = pictureLeft * (light - sun) + sun;
    sun *= 1.0 - 2.0 * softShare(0.5 * pictureLeft); // with half of the light left by its own crown
#else
    light *= pictureLeft;
#endif
    vec3 tint = mix(vec3(1.0), leafTint, lobe.a);
    vec3 albedo = tint * color.rgb / color.a;
    light = shadowed(light, sun, mix(pictureEye, pictureFront, lobe.a));
    paintSurface(sceneColor(albedo * max(light, 0.0), pictureEye), albedo);
}
