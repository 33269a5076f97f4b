// SPDX-License-Identifier: MIT
// Leaves of one kind are of many greens: up to 12 degrees of hue and 15 % of saturation from cluster to cluster, and half
// as much from tree to tree.

/// Factor on the colour of a leaf. @param hue 1: 12 degrees from yellow toward blue, -1: the other way.
/// @param saturation 1: 15 % more. Both as seen (in sRGB), the luminance of a green leaf being kept.
vec3 leafTint(float hue, float saturation) {
    return vec3(1.0f - 0.20f * hue - 0.03f * saturation, 1.0f + 0.04f * hue + 0.02f * saturation,
                1.0f + 0.06f * hue - 0.24f * saturation);
}

/// @param own number of the tree, [0, 1).
vec3 treeTint(float own) {
    return leafTint(fract(11.0f * own) - 0.5f, fract(23.0f * own) - 0.5f);
}

/// Its brightness among them, 12 % up or down. @param leaf index in the tree.
vec3 clusterTint(float own, float leaf) {
    float hue = 2.0f * fract(0.569840f * leaf + 3.0f * own) - 1.0f;
    float saturation = 2.0f * fract(0.819173f * leaf + 7.0f * own) - 1.0f;
    return (0.88f + 0.24f * fract(0.754878f * leaf + own)) * leafTint(hue, saturation);
}

/// What a texel of leaves or bark reflects over the colour of its kind. @param hue from bluish (0) over that colour to
/// yellowish (1).
vec3 texelTint(float brightness, float hue) {
    return brightness * (1.0f + (hue - 0.5f) * vec3(0.5f, 0.1f, -0.4f));
}

/// How much of the colour of stems wood has; the rest is that of twigs. @param radius m.
float stemShare(float radius) { return smoothstep(0.005f, 0.025f, radius); }
