// SPDX-License-Identifier: MIT
// What a texel of a leaf texture means (osgTreeWind/nodes/LeafTexels.h).

/// What leaves reflect over the colour of the species' leaves: brightness, with a hue from bluish to yellowish.
vec3 leafTint(vec4 texel) {
    return texel.r * (1.0 + (texel.g - 0.5) * vec3(0.5, 0.1, -0.4));
}
