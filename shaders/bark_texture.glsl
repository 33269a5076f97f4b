// SPDX-License-Identifier: MIT
// Decodes the bark texture (osgTreeWind/drawing/looks/BarkRelief.h).
#pragma import_defines(UNLIT)

#include "law/tint.glsl"
#include "shadowed.glsl"

uniform sampler2D barkTexture; // brightness, height and hue of old bark; brightness of young bark
uniform vec3 barkColor, oldBarkColor, twigColor;
uniform vec3 barkAgeing; // law/tint.glsl

const float thickRadius = 0.175; // of the thinnest stem with plates of full size (osgTreeWind/model/BranchSkin.h), m
const float youngRelief = 0.35; // height of the relief of young bark over that of old bark
const float fineness = 5.0, roughness = 0.3; // frequency and height of the fine relief, over those of the coarse one

/// Texture coordinate of bark; u runs from 0 to 2 around the stem. Rings have no extra vertices at the seam, where u
/// falls from nearly 2 to 0. There it takes a second u, whose seam is on the opposite side (Tarini 2012, Cylindrical
/// and toroidal parameterizations without vertex seams). @param around u, v, second u.
vec2 coordOnBark(vec3 around) {
    return fwidth(around.x) < 1.5 * fwidth(around.z) ? around.xy : around.zy;
}

/// How often the texture repeats around half the stem: twice as often from one octave of the radius to the next, so
/// that plates have one size on thick stems. Strips along the stem change at different radii, as ridges part.
float barkRepeats(float u, float radius) {
    float strip = fract(0.35 * floor(10.0 * u)); // the same at u and u - 2
    return exp2(floor(log2(max(radius / thickRadius, 1.0)) + 0.3 + 0.4 * strip));
}

/// Slope of the relief toward the sun, from texels a pixel apart, or neighbouring texels if these are larger.
/// @param heights weights of the texture's channels. @param texel at `coord`. @param toSun change of the coordinate per
/// pixel. @param size of a pixel, in texels.
float slopeToSun(vec4 heights, vec4 texel, vec2 coord, vec2 toSun, float size, float lod) {
    float apart = max(1.0, 1.0 / size);
    return dot(heights, textureLod(barkTexture, coord + apart * toSun, lod) - texel) / (apart * size);
}

/// Brightness of the relief: slopes toward the sun are brighter.
/// @param old share of old bark. @param texel at `coord`.
float barkRelief(float old, vec4 texel, vec2 coord, vec2 across, vec2 along, float size, float lod) {
#ifdef UNLIT
    return 1.0;
#else
    vec2 sun = normalize(osg_LightSource[SUN].position.xyz).xy, toSun = sun.x * across + sun.y * along;
    vec4 heights = vec4(0.0, old, 0.0, youngRelief * (1.0 - old));
    float slope = slopeToSun(heights, texel, coord, toSun, size, lod);
    if (size < 0.4) {
        vec2 fine = fineness * coord;
        slope += roughness * (1.0 - smoothstep(0.15, 0.4, size)) *
                 slopeToSun(heights, textureLod(barkTexture, fine, 0.0), fine, toSun, size, 0.0);
    }
    return 1.0 - clamp(10.0 * slope, -0.5, 0.5);
#endif
}

/// Albedo of bark. @param girth radius of the wood and its height above the ground, m.
vec3 barkAlbedo(vec2 coord, vec2 girth) {
    vec2 repeats = vec2(barkRepeats(coord.x, girth.x), 1.0), place = repeats * coord;
    vec2 across = repeats * dFdx(coord), along = repeats * dFdy(coord);
    float size = float(textureSize(barkTexture, 0).x) * sqrt(0.5 * (dot(across, across) + dot(along, along))) + 1.0e-4;
    float lod = log2(size);
    vec4 texel = textureLod(barkTexture, place, lod);
    float old = oldShare(barkAge(girth.x, girth.y, barkAgeing), texel.g);
    vec3 color = mix(texel.a * barkColor, texel.r * oldBarkColor, old);
    color *= barkRelief(old, texel, place, across, along, size, lod) * texelTint(1.0, texel.b);
    return mix(twigColor, color, stemShare(girth.x));
}
