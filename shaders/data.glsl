// SPDX-License-Identifier: MIT
// Arrays in RGBA32F textures, 2048 texels wide (osgTreeWind/gpu/DataTexture.h). Shifts replace slow integer division.

vec4 dataTexel(sampler2D data, int index) {
    return texelFetch(data, ivec2(index & 2047, index >> 11), 0);
}

/// A 32-bit integer from two floats, low half first.
uint wholeNumber(vec2 halves) {
    return uint(halves.x) + (uint(halves.y) << 16u);
}
