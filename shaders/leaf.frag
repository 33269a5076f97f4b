#version 330 compatibility
// SPDX-License-Identifier: MIT

uniform sampler2D leafTexture; // colour variation, alpha: shape
uniform vec3 leafColor;

in vec2 leafCoord;
in vec3 leafLight;

void main() {
    vec4 leaf = texture(leafTexture, leafCoord);
    // Mipmaps wash the shape out; keep the crown as dense far away as it is close by.
    vec2 footprint = fwidth(leafCoord) * vec2(textureSize(leafTexture, 0));
    float level = log2(max(max(footprint.x, footprint.y), 1.0));
    if (leaf.a * (1.0 + 0.12 * level) < 0.45)
        discard;
    gl_FragColor = vec4(leaf.rgb * leafColor * leafLight, 1.0);
}
