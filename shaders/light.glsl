// SPDX-License-Identifier: MIT
// The lights of the scene as OSG sets them (osgTreeWind/drawing/looks/SceneShading.h), an ambient light from the sky,
// and what the ground reflects of both.
#pragma import_defines(UNLIT)

#include "law/shade.glsl"
#include "shadowed.glsl"

#ifdef SHADOWED
out
#endif
vec3 sunLight; // the sun's part in the last result of lightOn()

/// Light of the sky.
vec3 ambientLight() {
    vec3 ambient = sceneAmbient.rgb;
    for (int n = 0; n < lights.length(); ++n)
        ambient += osg_LightSource[lights[n]].ambient.rgb;
    return ambient;
}

/// Light that open ground reflects. @param level light on it: of the sky, and of other lights times their cosine.
vec3 groundLight(vec3 level) { return vec3(0.11, 0.10, 0.06) * level; }

vec3 upward() { return normalize(osg_NormalMatrix * vec3(0.0, 0.0, 1.0)); } // in eye space

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

/// Transmittance of a leaf over its reflectance (Jacquemoud and Baret 1990, PROSPECT).
const vec3 transmittance = vec3(0.87, 0.92, 0.25);

/// Light that blades send to the eye, over the light on them, beside the part that is linear in the normal.
/// @param along cosine between the direction of sight and that to the light. @param turned whether the eye sees the
/// other side than the light.
vec3 bladeScattering(float along, bool turned) {
    float both = 0.14 + 0.08 * along * along;
    return both * (turned ? transmittance : vec3(1.0));
}

/// Its mean over blades of all directions (Ross 1981; Shultis and Myneni 1988).
vec3 meanScattering(float along) {
    float half_ = 0.07 + 0.04 * along * along;
    return half_ - 0.11 * along + (half_ + 0.11 * along) * transmittance;
}

/// Shares of the light that the crown leaves at a place, in the frame of the tree (law/shade.glsl).
struct Shade {
    vec4 above; // w: of the sky
    vec4 below; // w: of the ground's light
    vec2 heading; // cosine and sine
    float around; // share that neighbours leave of the sky, and of the sun if the scene has no shadows
};

const float fleck = 0.4; // least share of the sun that leaves within SHADOW_CLEARANCE leave; shadows hold the others

/// Share of the light from a direction.
float shareOf(vec3 toLight, Shade shade) {
    vec3 d = toLight * osg_NormalMatrix; // by the inverse of the model-view matrix
    vec2 turn = shade.heading;
    return shareFrom(vec3(turn.x * d.x + turn.y * d.y, turn.x * d.y - turn.y * d.x, d.z), shade.above, shade.below);
}

/// Light on bark or foliage. Foliage is lit from both sides and transmits light. Its light is linear in the normal, so
/// that the mean normal gives the mean light.
/// @param blade normal of a leaf, either way; 0 for bark.
vec3 lightOn(bool leaf, vec3 eyePosition, vec3 eyeNormal, vec3 blade, Shade shade) {
    sunLight = vec3(0.0);
#ifdef UNLIT
    return vec3(1.0);
#endif
    vec3 up = upward(), ambient = ambientLight(), level = ambient, sight = normalize(eyePosition);
    vec3 light = vec3(0.0);
    for (int n = 0; n < lights.length(); ++n) {
        int i = lights[n];
        vec4 at = lightAt(i, eyePosition);
        float facing = dot(eyeNormal, at.xyz), share = shareOf(at.xyz, shade);
        vec3 lit = leaf ? 0.25 + 0.25 * facing +
                              bladeScattering(dot(sight, at.xyz), dot(blade, sight) * dot(blade, at.xyz) > 0.0)
                        : vec3(max(facing, 0.0));
        float left = osg_LightSource[i].position.w == 0.0 ? share * shade.around : share;
        vec3 full = at.w * osg_LightSource[i].diffuse.rgb;
        level += max(dot(up, at.xyz), 0.0) * full;
        lit *= full;
#ifdef SHADOWED
        if (n == 0) {
            float inShadow = softShare(left);
            sunLight = (max(share, fleck) - inShadow) * lit;
            light += sunLight;
            left = inShadow;
        }
#else
        if (n == 0)
            sunLight = left * lit;
#endif
        light += left * lit;
    }
    vec3 sky = leaf ? mix(vec3(1.0), transmittance, max(dot(sight, up), 0.0)) : vec3(1.0 + 0.3 * dot(eyeNormal, up));
    return light + shade.around * (shade.above.w * sky * ambient + shade.around * shade.below.w * groundLight(level));
}

vec3 barkShade(vec3 eyePosition, vec3 eyeNormal, Shade shade) {
    return lightOn(false, eyePosition, eyeNormal, vec3(0.0), shade);
}
vec3 leafShade(vec3 eyePosition, vec3 eyeNormal, vec3 blade, Shade shade) {
    return lightOn(true, eyePosition, eyeNormal, blade, shade);
}

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
/// `sunLight` * (0.25 + leaf * `sunScattering` + dot(sunWay, normal) / 2).
void linearLight(vec3 eyePosition, out vec3 bark, out vec3 leafMore, out mat3 byNormal, out vec3 sunScattering,
                 out vec3 sunWay) {
    bark = vec3(1.0);
    leafMore = vec3(0.0);
    byNormal = mat3(0.0);
    sunLight = vec3(0.0);
    sunScattering = vec3(0.0);
    sunWay = vec3(0.0);
#ifndef UNLIT
    vec3 up = upward(), level = ambientLight();
    bark = level;
    for (int n = 0; n < lights.length(); ++n) {
        int i = lights[n];
        vec4 at = lightAt(i, eyePosition);
        vec3 light = at.w * osg_LightSource[i].diffuse.rgb;
        vec3 scattering = meanScattering(dot(normalize(eyePosition), at.xyz));
        level += max(dot(up, at.xyz), 0.0) * light;
        bark += 0.25 * light;
        leafMore += scattering * light;
        byNormal += outerProduct(0.5 * light, at.xyz);
        if (n == 0) {
            sunLight = light;
            sunScattering = scattering;
            sunWay = at.xyz;
        }
    }
    bark += groundLight(level);
#endif
}
