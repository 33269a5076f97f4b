// SPDX-License-Identifier: MIT

/// What a texel reflects over the colour of leaves or bark: its brightness, and its hue from bluish (0) to yellowish (1).
vec3 texelTint(float brightness, float hue) {
    return brightness * (1.0 + (hue - 0.5) * vec3(0.5, 0.1, -0.4));
}
