// SPDX-License-Identifier: MIT
/// What the scene makes of a lit colour on its way to the eye.
vec3 sceneColor(vec3 color, vec3 eyePosition) {
    return color;
}
