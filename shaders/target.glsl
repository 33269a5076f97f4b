// SPDX-License-Identifier: MIT
/// Element of a pass's target that this fragment stands for.
int targetIndex(sampler2D target) {
    return int(gl_FragCoord.y) * textureSize(target, 0).x + int(gl_FragCoord.x);
}
