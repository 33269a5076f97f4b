// SPDX-License-Identifier: MIT
// Round crowns, with shading, in random cells of a grid. If they are smaller than a pixel, only their mean cover.

#include "dither.glsl"
#include "law/tint.glsl"
#include "scene.glsl"
#include "surface.glsl"

flat in vec4 crownGrid;
flat in vec4 crownColor;
flat in vec3 crownLight;
flat in mat3 lightByNormal;
flat in vec3 crownToEye;
flat in vec3 crownAcross;
flat in vec3 crownUp;
#ifdef SHADOWED
flat in vec3 crownSunScattering;
flat in vec3 crownSunWay;
#endif
in vec2 crownPlace;
in vec3 crownEye;

const float roundShare = 0.785398; // share of a cell that its crown covers
const float within = 0.39;         // mean share of the light within a crown, to match the brightness of impostors

uint mixed(uint h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= 0x846ca68bu;
    return h ^ (h >> 16);
}

void main() {
    float width = crownGrid.x, share = crownGrid.y;
    vec2 place = crownPlace / width;
    float pixel = max(length(dFdx(place)), length(dFdy(place)));
    vec2 square = floor(place);
    uint hash = mixed(uint(int(square.x) + 4096) * 8192u + uint(int(square.y) + 4096) + uint(crownGrid.z * 65536.0) * 0x9e3779b9u);
    // Overlapping crowns: the probability that at least one of them covers a cell.
    float covered = 1.0 - exp(-share), solid = mix(0.55, 1.0, crownColor.a);
    vec2 off = 2.0 * (place - square) - 1.0;
    float radius = 1.0 + 0.45 * smoothstep(0.6, 1.0, covered); // no holes between the crowns of a closed stand
    float r = length(off) / radius;
    bool there = float(hash & 0xffffu) < 65536.0 * covered && r < 1.0;
    float seen = there ? solid : 0.0;
    seen = mix(seen, min(covered * roundShare * radius * radius, 1.0) * solid, smoothstep(0.5, 1.2, pixel));
    if (seen <= fract(evenNoise() + crownGrid.z)) // differs between squares, so that layers add up
        discard;

    float own = float(hash >> 16) / 65536.0;
    vec2 bulge = off / radius * (1.0 - smoothstep(0.5, 1.2, pixel));
    vec3 normal = bulge.x * crownAcross + bulge.y * crownUp + sqrt(max(1.0 - dot(bulge, bulge), 0.1)) * crownToEye;
    normal *= 0.5; // leaves are lit from both sides
    vec3 light = within * (crownLight + lightByNormal * normal);
    vec3 sun = sunLight;
#ifdef SHADOWED
    sun *= within * (0.25 + crownSunScattering + 0.5 * dot(crownSunWay, normal));
#endif
    vec3 albedo = crownColor.rgb * treeTint(own);
    paintSurface(sceneColor(albedo * max(shadowed(light, sun, crownEye), 0.0), crownEye), albedo);
}
