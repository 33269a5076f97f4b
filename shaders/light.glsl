// SPDX-License-Identifier: MIT
// The lights of the scene as OSG sets them (osgTreeWind/drawing/looks/SceneShading.h), and an ambient light that is
// brighter from above.
#pragma import_defines(UNLIT)

#include "law/shade.glsl"
#include "shadowed.glsl"

#ifdef SHADOWED
out
#endif
vec3 sunLight; // the sun's part in the last result of lightOn()

vec3 ambientLight(vec3 eyeNormal) {
    vec3 ambient = sceneAmbient.rgb;
    for (int n = 0; n < lights.length(); ++n)
        ambient += osg_LightSource[lights[n]].ambient.rgb;
    vec3 eyeUp = normalize(osg_NormalMatrix * vec3(0.0, 0.0, 1.0));
    float sky = 0.5 + 0.5 * dot(eyeNormal, eyeUp);
    return ambient * mix(vec3(0.75, 0.72, 0.62), vec3(1.1, 1.2, 1.35), sky);
}

/// Direction to a light, and its attenuation.
vec4 lightAt(int i, vec3 eyePosition) {
    vec4 place = osg_LightSource[i].position;
    if (place.w == 0.0)
        return vec4(normalize(place.xyz), 1.0);
    vec3 way = place.xyz / place.w - eyePosition;
    float far = length(way);
    vec3 toLight = way / max(far, 1.0e-6);
    float left = 1.0 / (osg_LightSource[i].constantAttenuation +
                        far * (osg_LightSource[i].linearAttenuation + far * osg_LightSource[i].quadraticAttenuation));
    if (osg_LightSource[i].spotCutoff <= 90.0) {
        float along = dot(-toLight, normalize(osg_LightSource[i].spotDirection));
        left *= along < cos(radians(osg_LightSource[i].spotCutoff)) ? 0.0 : pow(max(along, 0.0), osg_LightSource[i].spotExponent);
    }
    return vec4(toLight, left);
}

/// Share of a light that leaves transmit toward the eye, yellower than the reflected light.
vec3 lightThrough(vec3 eyePosition, vec3 toLight) {
    float against = max(dot(normalize(eyePosition), toLight), 0.0);
    return against * against * against * against * vec3(0.42, 0.40, 0.14);
}

/// Shares of the light that the crown leaves at a place, in the frame of the tree (law/shade.glsl).
struct Shade {
    vec4 above;
    vec4 below;
    vec2 heading; // cosine and sine
    float around; // share that neighbours leave of the sky, and of the sun if the scene has no shadows
};
#ifdef SHADOWED
#define AROUND_SUN(share) 1.0
#else
#define AROUND_SUN(share) share
#endif

/// Share of the light from a direction.
float shareOf(vec3 toLight, Shade shade) {
    vec3 d = toLight * osg_NormalMatrix; // by the inverse of the model-view matrix
    vec2 turn = shade.heading;
    return shareFrom(vec3(turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x, d.z), shade.above, shade.below);
}

/// Light on bark or foliage. Foliage is lit from both sides and transmits light. Its light is linear in the normal, so
/// that the mean normal gives the mean light.
vec3 lightOn(bool leaf, vec3 eyePosition, vec3 eyeNormal, Shade shade) {
    sunLight = vec3(0.0);
#ifdef UNLIT
    return vec3(1.0);
#endif
    vec3 light = shade.around * shade.above.w * ambientLight(eyeNormal);
    for (int n = 0; n < lights.length(); ++n) {
        int i = lights[n];
        vec4 at = lightAt(i, eyePosition);
        float facing = dot(eyeNormal, at.xyz);
        vec3 lit = leaf ? max(0.5 * facing + 0.5, 0.0) + lightThrough(eyePosition, at.xyz) : vec3(max(facing, 0.0));
        float left = osg_LightSource[i].position.w == 0.0 ? AROUND_SUN(shade.around) : 1.0;
        vec3 part = left * at.w * shareOf(at.xyz, shade) * lit * osg_LightSource[i].diffuse.rgb;
        light += part;
        if (n == 0)
            sunLight = part;
    }
    return light;
}

vec3 barkShade(vec3 eyePosition, vec3 eyeNormal, Shade shade) { return lightOn(false, eyePosition, eyeNormal, shade); }
vec3 leafShade(vec3 eyePosition, vec3 eyeNormal, Shade shade) { return lightOn(true, eyePosition, eyeNormal, shade); }

/// Factor on the sun's light on a leaf, with mean 1: leaves of a crown face all directions, and glint as they turn.
/// @param leaf index in the tree. @param rest, now unit normals of the blade at rest and now, in eye space.
float bladeGlint(float leaf, vec3 rest, vec3 now) {
    vec4 sun = osg_LightSource[SUN].position;
    vec3 toSun = normalize(sun.xyz);
    return 0.5 + fract(0.381966 * leaf + 0.13) + 0.8 * (abs(dot(now, toSun)) - abs(dot(rest, toSun)));
}

/// Light for impostors, whose pictures include the shade (osgTreeWind/drawing/impostors/LightLobe.h), for all normals
/// at once: the light is `bark` + leaf * `leafMore` + `byNormal` * normal, with leaf 1 or 0. Exact for leaves; for bark
/// it uses the linear function nearest to max(cosine, 0). The sun's part is
/// `sunLight` * (0.25 + leaf * (0.25 + sunThrough) + dot(sunWay, normal) / 2).
void linearLight(vec3 eyePosition, out vec3 bark, out vec3 leafMore, out mat3 byNormal, out vec3 sunThrough,
                 out vec3 sunWay) {
    bark = vec3(1.0);
    leafMore = vec3(0.0);
    byNormal = mat3(0.0);
    sunLight = vec3(0.0);
    sunThrough = vec3(0.0);
    sunWay = vec3(0.0);
#ifndef UNLIT
    vec3 eyeUp = normalize(osg_NormalMatrix * vec3(0.0, 0.0, 1.0));
    bark = ambientLight(vec3(0.0));
    byNormal = outerProduct(ambientLight(eyeUp) - bark, eyeUp);
    for (int n = 0; n < lights.length(); ++n) {
        int i = lights[n];
        vec4 at = lightAt(i, eyePosition);
        vec3 light = at.w * osg_LightSource[i].diffuse.rgb;
        bark += 0.25 * light;
        leafMore += (0.25 + lightThrough(eyePosition, at.xyz)) * light;
        byNormal += outerProduct(0.5 * light, at.xyz);
        if (n == 0) {
            sunLight = light;
            sunThrough = lightThrough(eyePosition, at.xyz);
            sunWay = at.xyz;
        }
    }
#endif
}
