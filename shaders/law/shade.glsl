// SPDX-License-Identifier: MIT
// Share of the light that the crown leaves at a place in the tree (osgTreeWind/model/CrownShade.h). Each of two floats
// packs the square roots of four shares in steps of 1/63; 0 means no loss.

vec4 unpackedShares(float four) {
    vec4 root = 1.0f - floor(64.0f * fract(four * vec4(1.0f, 64.0f, 4096.0f, 262144.0f))) * (1.0f / 63.0f);
    return root * root;
}

float packedShares(vec4 shares) {
    vec4 steps = floor(63.5f - 63.0f * sqrt(clamp(shares, 0.0f, 1.0f)));
    return dot(steps, vec4(262144.0f, 4096.0f, 64.0f, 1.0f)) * (1.0f / 16777216.0f);
}

/// Shading area of a crown over that in leaf: bare twigs have a third of the leaves' area. @param leaves share of them.
float shadingArea(float leaves) { return mix(0.33f, 1.0f, leaves); }

/// Shares of the light that a crown with a share of its leaves leaves, from those in leaf.
vec4 sharesInSeason(vec4 inLeaf, float leaves) {
    return leaves < 1.0f ? pow(inLeaf, vec4(shadingArea(leaves))) : inLeaf;
}

/// Share of the light from a direction, interpolated between the axes. @param above shares from +x, +y, +z; w: of the
/// sky. @param below shares from -x, -y, -z; w: of the light from the ground.
float shareFrom(vec3 direction, vec4 above, vec4 below) {
    vec3 weight = direction * direction;
    float sum = weight.x * (direction.x > 0.0f ? above.x : below.x) + weight.y * (direction.y > 0.0f ? above.y : below.y) +
                weight.z * (direction.z > 0.0f ? above.z : below.z);
    return sum / max(weight.x + weight.y + weight.z, 1.0e-9f);
}
