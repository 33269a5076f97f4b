// SPDX-License-Identifier: MIT
// Decodes the bark texture (osgTreeWind/drawing/looks/BarkRelief.h).
#pragma import_defines(UNLIT)

#include "law/tint.glsl"
#include "shadowed.glsl"

uniform sampler2D barkTexture; // brightness, height, hue
uniform vec3 barkColor, twigColor;

const float fineness = 5.0, roughness = 0.3; // frequency and height of the fine relief, over those of the coarse one

/// Texture coordinate of bark; u runs from 0 to 2 around the stem. Rings have no extra vertices at the seam, where u
/// falls from nearly 2 to 0. There it takes a second u, whose seam is on the opposite side (Tarini 2012, Cylindrical
/// and toroidal parameterizations without vertex seams). @param around u, v, second u.
vec2 coordOnBark(vec3 around) {
    return fwidth(around.x) < 1.5 * fwidth(around.z) ? around.xy : around.zy;
}

/// Slope of the relief along u and v. @param height at `coord`.
vec2 texelSlope(float height, vec2 coord, vec2 texels) {
    float beside = textureLod(barkTexture, coord + vec2(1.0 / texels.x, 0.0), 0.0).g;
    float above = textureLod(barkTexture, coord + vec2(0.0, 1.0 / texels.y), 0.0).g;
    return texels * (vec2(beside, above) - height);
}

/// Slope of the bark toward the right and the top of the screen, per pixel. If texels are larger than pixels, it is
/// computed from neighbouring texels, for a smooth surface, plus the relief on a smaller scale.
vec2 barkRise(float height, vec2 coord, vec2 across, vec2 along) {
    vec2 rise = vec2(dFdx(height), dFdy(height));
    vec2 texels = vec2(textureSize(barkTexture, 0));
    float pixel = max(length(texels * across), length(texels * along)); // in texels
    if (pixel < 1.0) {
        vec2 slope = texelSlope(height, coord, texels);
        if (pixel < 0.4) {
            vec2 fine = fineness * coord;
            vec2 rough = texelSlope(textureLod(barkTexture, fine, 0.0).g, fine, texels);
            slope += roughness * (1.0 - smoothstep(0.15, 0.4, pixel)) * rough;
        }
        rise = mix(vec2(dot(slope, across), dot(slope, along)), rise, smoothstep(0.6, 1.0, pixel));
    }
    return rise;
}

/// Brightness of the relief: slopes toward the sun are brighter. Uses screen-space derivatives instead of tangents.
float barkRelief(float height, vec2 coord) {
#ifdef UNLIT
    return 1.0;
#else
    vec2 across = dFdx(coord), along = dFdy(coord);
    float pixel = sqrt(0.5 * (dot(across, across) + dot(along, along))) + 1.0e-6; // in widths of the bark
    vec2 slope = barkRise(height, coord, across, along) / pixel;
    vec2 toLight = normalize(osg_LightSource[SUN].position.xyz).xy;
    return 1.0 - clamp(0.04 * dot(slope, toLight), -0.5, 0.5);
#endif
}

/// Albedo of bark, between the colours of twigs and stems. @param radius of the wood, m.
vec3 barkAlbedo(vec2 coord, float radius) {
    vec3 texel = texture(barkTexture, coord).rgb;
    vec3 color = mix(twigColor, barkColor, stemShare(radius));
    return barkRelief(texel.g, coord) * texelTint(texel.r, texel.b) * color;
}
