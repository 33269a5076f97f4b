// SPDX-License-Identifier: MIT
// What a texel of bark means (osgTreeWind/drawing/looks/BarkRelief.h).
#pragma import_defines(UNLIT)

#include "law/tint.glsl"
#include "shadowed.glsl"

uniform sampler2D barkTexture; // brightness, height, hue
uniform vec3 barkColor, twigColor;

const float fineness = 5.0, roughness = 0.3; // of the fine relief: how much smaller, and how high over itself

/// Where bark is on the texture, which reaches twice around. Rings have no vertices to spare for a seam: between two of
/// them u falls from nearly 2 to 0, and there another u goes on, whose seam is on the other side (Tarini 2012, Cylindrical
/// and toroidal parameterizations without vertex seams). @param around u, v, the other u.
vec2 coordOnBark(vec3 around) {
    return fwidth(around.x) < 1.5 * fwidth(around.z) ? around.xy : around.zy;
}

/// Rise of the height of texels from a place toward greater u and v. @param height there.
vec2 texelSlope(float height, vec2 coord, vec2 texels) {
    float beside = textureLod(barkTexture, coord + vec2(1.0 / texels.x, 0.0), 0.0).g;
    float above = textureLod(barkTexture, coord + vec2(0.0, 1.0 / texels.y), 0.0).g;
    return texels * (vec2(beside, above) - height);
}

/// Rise of the bark toward the right and the top of the screen, from pixel to pixel. Where a texel is larger than a pixel
/// it comes from texels, so that close by it has no steps; there the same relief, smaller, roughens what would be bare.
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

/// What the sun makes of the relief: slopes toward it are brighter. No tangents: they are taken on the screen.
float barkRelief(float height, vec2 coord) {
#ifdef UNLIT
    return 1.0;
#else
    vec2 across = dFdx(coord), along = dFdy(coord);
    float pixel = sqrt(0.5 * (dot(across, across) + dot(along, along))) + 1.0e-6; // in widths of the bark
    vec2 slope = barkRise(height, coord, across, along) / pixel;
    vec2 toLight = normalize(gl_LightSource[SUN].position.xyz).xy;
    return 1.0 - clamp(0.04 * dot(slope, toLight), -0.5, 0.5);
#endif
}

/// What bark reflects: that of twigs has another colour than that of stems. @param radius of the wood, m.
vec3 barkAlbedo(vec2 coord, float radius) {
    vec3 texel = texture(barkTexture, coord).rgb;
    vec3 color = mix(twigColor, barkColor, stemShare(radius));
    return barkRelief(texel.g, coord) * texelTint(texel.r, texel.b) * color;
}
