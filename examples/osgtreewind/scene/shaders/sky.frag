#version 330 compatibility
// SPDX-License-Identifier: MIT
in vec2 spot;
uniform sampler2D sky;
void main() {
    gl_FragColor = vec4(texture(sky, spot).rgb, 1.0);
}
