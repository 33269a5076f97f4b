// SPDX-License-Identifier: MIT
in vec2 spot;
uniform sampler2D sky;
out vec4 pixelColor;
void main() {
    pixelColor = vec4(texture(sky, spot).rgb, 1.0);
}
