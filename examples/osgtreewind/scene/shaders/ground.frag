// SPDX-License-Identifier: MIT
// The texture is used at rotated scales without simple ratios, so that its repetition does not show.
in vec2 place;
in vec4 haze;
in float fine;
#ifdef TUFTS
in float rise, shade; // shade: above 1 on herbs
#define WORN 0.25 // tufts on worn patches are greener than the patches
#else
#define WORN 0.45
#endif
#ifdef SHADOWED
in vec3 eyePosition;
#else
in vec3 sunOnIt;
#endif
uniform vec3 skyLight, litter;
uniform vec3 season;             // factor for the colour of grass
uniform sampler2D groundTexture; // red: patches, green: worn ones, blue: blades of grass, alpha: fallen leaves
#ifdef COVERED
uniform sampler2D groundCover;   // red: cover by crowns, green: sky hidden by trunks
uniform vec4 coverPlace;         // corner, 1 / size
#endif
out vec4 pixelColor;
void main() {
    vec2 p = place;
    vec2 q = vec2(0.80 * p.x - 0.60 * p.y, 0.60 * p.x + 0.80 * p.y);
    vec2 r = vec2(0.28 * p.x + 0.96 * p.y, 0.28 * p.y - 0.96 * p.x);
    vec3 wide = texture(groundTexture, q / 613.0).rgb;
    vec3 near = mix(vec3(0.5), texture(groundTexture, r / 37.0).rgb, fine);
#ifdef TUFTS
    float blades = 0.15 + 0.35 * rise + 0.35 * fract(shade), leaf = 1.1;
#else
    vec2 texel = texture(groundTexture, p / 2.7).ba;
    float blades = texel.x, leaf = texel.y;
#endif
    float tone = smoothstep(0.2, 0.8, 0.5 * (wide.r + near.r));
    vec3 grass = season * mix(vec3(0.048, 0.074, 0.020), vec3(0.112, 0.132, 0.046), tone);
    float worn = smoothstep(0.48, 0.72, 0.55 * wide.g + 0.45 * near.g);
    grass = mix(grass, vec3(0.165, 0.150, 0.075), WORN * worn);
    vec3 sky = 1.7 * skyLight;
#ifdef COVERED
    vec2 cover = texture(groundCover, (p - coverPlace.xy) * coverPlace.zw).rg;
    // Moss grows in patches and around trunks. The first leaves lie alone; below closed crowns they cover the ground.
    float moss = smoothstep(0.45, 0.7, near.g + cover.g) * cover.r;
    grass = mix(grass, vec3(0.05, 0.085, 0.018), 0.8 * moss);
    float fallen = smoothstep(0.05, 0.9, cover.r + 0.5 * (near.r - 0.5)) * (1.0 - 0.6 * moss),
          lies = clamp(mix(1.2, 3.0, pow(fine, 8.0)) * (1.3 * fallen - leaf), 0.0, 1.0);
    grass = mix(grass, litter * (0.6 + 0.7 * leaf) * vec3(1.0, 0.85 + 0.2 * fract(9.0 * leaf), 1.0), lies);
    blades = mix(blades, 0.35 + 0.3 * near.r, 0.7 * lies);
    sky *= (1.0 - 0.6 * cover.r) * (1.0 - cover.g);
#endif
#ifdef TUFTS
    grass = mix(grass, season * vec3(0.038, 0.078, 0.018), step(1.0, shade));
#endif
#ifdef SHADOWED
    vec3 light = shadowed(sky + sunLight, sunLight, eyePosition);
#else
    vec3 light = sky + sunOnIt;
#endif
    pixelColor = vec4(mix(haze.rgb, encoded((0.35 + 1.3 * blades) * grass * light), haze.a), 1.0);
}
