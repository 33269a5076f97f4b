// SPDX-License-Identifier: MIT
// Variation of leaf colours within a species: up to 9 degrees of hue and 15 % of saturation between trees, and up to 10
// degrees between clusters.

/// Factor on the colour of a leaf, which keeps the luminance of a green leaf. @param hue 1: 12 degrees from yellow
/// toward blue, -1: the opposite. @param saturation 1: 15 % more. Both in sRGB.
vec3 leafTint(float hue, float saturation) {
    return vec3(1.0f - 0.20f * hue - 0.03f * saturation, 1.0f + 0.04f * hue + 0.02f * saturation,
                1.0f + 0.06f * hue - 0.24f * saturation);
}

/// Includes a variation of the brightness by 10 %. @param own number of the tree, [0, 1).
vec3 treeTint(float own) {
    float hue = 1.5f * fract(11.0f * own) - 0.75f, saturation = 2.0f * fract(23.0f * own) - 1.0f;
    return (0.90f + 0.20f * fract(37.0f * own)) * leafTint(hue, saturation);
}

/// Includes a variation of the brightness by 12 %. @param leaf index in the tree.
vec3 clusterTint(float own, float leaf) {
    float hue = 1.7f * fract(0.569840f * leaf + 3.0f * own) - 0.85f;
    float saturation = 2.0f * fract(0.819173f * leaf + 7.0f * own) - 1.0f;
    return (0.88f + 0.24f * fract(0.754878f * leaf + own)) * leafTint(hue, saturation);
}

/// Albedo of a texel of leaves or bark over the colour of the species. @param hue from bluish (0) to yellowish (1);
/// 0.5: no change.
vec3 texelTint(float brightness, float hue) {
    return brightness * (1.0f + (hue - 0.5f) * vec3(0.5f, 0.1f, -0.4f));
}

/// Share of old bark on wood; the rest is young and smooth. @param radius m. @param height above the ground, m.
/// @param ageing radii at which bark at the ground begins to crack and is old throughout, m, and by how much thicker
/// wood must be per metre of height.
float barkAge(float radius, float height, vec3 ageing) {
    return smoothstep(ageing.x, ageing.y, radius - ageing.z * height);
}

/// Share of old bark at a place on it: cracks open while the ridges between them are still smooth.
/// @param height of the relief there, [0, 1].
float oldShare(float age, float height) { return clamp(2.0f * age - height, 0.0f, 1.0f); }

/// Share of the colour of stems in wood; the rest is the colour of twigs. @param radius m.
float stemShare(float radius) { return smoothstep(0.005f, 0.025f, radius); }
