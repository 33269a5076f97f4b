// SPDX-License-Identifier: MIT
// Display colour that the sun adds to haze in a direction.
uniform vec3 sunDirection, sunGlow;
vec3 glow(vec3 way) { return pow(max(dot(way, sunDirection), 0.0), 16.0) * sunGlow; }
