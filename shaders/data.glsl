// SPDX-License-Identifier: MIT
// Arrays kept in RGBA32F textures, 2048 texels wide (osgTreeWind/gpu/DataTexture.h). Shifts, since dividing whole
// numbers is slow.

vec4 dataTexel(sampler2D data, int index) {
    return texelFetch(data, ivec2(index & 2047, index >> 11), 0);
}

/// A whole number of 32 bits kept as two floats, low half first.
uint wholeNumber(vec2 halves) {
    return uint(halves.x) + (uint(halves.y) << 16u);
}
