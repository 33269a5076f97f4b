// SPDX-License-Identifier: MIT
// Arrays kept in RGBA32F textures (osgTreeWind/gpu/DataTexture.h).

vec4 dataTexel(sampler2D data, int index) {
    int width = textureSize(data, 0).x;
    return texelFetch(data, ivec2(index % width, index / width), 0);
}

/// A whole number of 32 bits kept as two floats, low half first.
uint wholeNumber(vec2 halves) {
    return uint(halves.x) + (uint(halves.y) << 16u);
}
