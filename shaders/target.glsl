// SPDX-License-Identifier: MIT
/// Index of the element that this fragment computes.
int targetIndex(sampler2D target) {
    return int(gl_FragCoord.y) * textureSize(target, 0).x + int(gl_FragCoord.x);
}
