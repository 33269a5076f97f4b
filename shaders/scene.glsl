// SPDX-License-Identifier: MIT
// Effects of the scene on a fragment: shadows, encoding of the colour, and fog, which is blended after the encoding as
// in OpenGL (osgTreeWind/drawing/looks/SceneShading.h).
// SHADOW_MAP: texture unit of osgShadow::ShadowMap. SHADOW_MAPS: number of maps of ViewDependentShadowMap.
// SHADOW_SLICES: number of slices of osgEarth's ShadowCaster.
// TIERS_COLORED: draws each tree in the `tierColor` of its level of detail, with its brightness.
// SHADOW_CLEARANCE: distance toward the light without shadow casters, metres: light.glsl shades within a crown.
#pragma import_defines(SHADOW_CLEARANCE, SHADOW_MAP, SHADOW_MAPS, SHADOW_MAP_UNIT0, SHADOW_MAP_UNIT1)
#pragma import_defines(SHADOW_SLICES, TIERS_COLORED)
#ifndef SHADOW_CLEARANCE
#define SHADOW_CLEARANCE 1.5
#endif

#include "encode.glsl"
#include "fog.glsl"
#include "shadowed.glsl"

#ifdef SHADOWED
in vec3 sunLight; // the sun's part of the light on the fragment
#else
const vec3 sunLight = vec3(0.0);
#endif

#if defined(TIERS_COLORED) && !defined(tierColor)
uniform vec3 tierColor;
#endif
#ifdef SHADOW_MAP
uniform sampler2DShadow osgShadow_shadowTexture;
uniform vec2 osgShadow_ambientBias; // replaces the sun's ambient light, which osgShadow::ShadowMap sets to black
#endif
#ifdef SHADOW_MAPS
uniform sampler2DShadow shadowTexture0;
#if SHADOW_MAPS > 1
uniform sampler2DShadow shadowTexture1;
#endif
#endif

#ifdef SHADOW_SLICES
uniform sampler2DArray oe_shadow_map; // depths, without comparison
uniform mat4 oe_shadow_matrix[SHADOW_SLICES]; // from eye space to a slice
#endif

#ifdef SHADOWED
/// Share of the sun's light outside shadows.
float sunLeft(vec3 eyePosition) {
    vec4 place = osg_LightSource[SUN].position;
    vec4 eye = vec4(eyePosition + SHADOW_CLEARANCE * normalize(place.xyz - place.w * eyePosition), 1.0);
    float left = 1.0;
#ifdef SHADOW_MAP
    left = osgShadow_ambientBias.x +
           osgShadow_ambientBias.y * textureProj(osgShadow_shadowTexture, shadowPlace(SHADOW_MAP, eye));
#endif
#ifdef SHADOW_MAPS
    vec4 place0 = shadowPlace(SHADOW_MAP_UNIT0, eye);
    left = textureProj(shadowTexture0, place0);
#if SHADOW_MAPS > 1
    if (any(greaterThan(abs(2.0 * place0.xyz - place0.w), vec3(place0.w)))) // outside the first map
        left = textureProj(shadowTexture1, shadowPlace(SHADOW_MAP_UNIT1, eye));
#endif
#endif
#ifdef SHADOW_SLICES
    for (int i = 0; i < SHADOW_SLICES; ++i) {
        vec3 slice = (oe_shadow_matrix[i] * eye).xyz;
        float depth = texture(oe_shadow_map, vec3(slice.xy, float(i))).r;
        if (all(lessThan(abs(slice - 0.5), vec3(0.5))) && depth < slice.z)
            left = 0.0;
    }
#endif
    return left;
}
#endif

/// Light on a fragment with shadows. @param light without shadows. @param sun the sun's part of it.
vec3 shadowed(vec3 light, vec3 sun, vec3 eyePosition) {
#ifdef SHADOWED
    return light - (1.0 - sunLeft(eyePosition)) * sun;
#else
    return light;
#endif
}

/// The final colour of a fragment, encoded and in fog. @param color lit, linear.
vec3 sceneColor(vec3 color, vec3 eyePosition) {
#ifdef TIERS_COLORED
    color = tierColor * (0.05 + 2.0 * dot(color, luminanceWeights));
#endif
    vec3 lit = encoded(color);
#ifdef FOG_MODE
    lit = mix(sceneFog.color.rgb, lit, fogLeft(eyePosition));
#endif
    return lit;
}
