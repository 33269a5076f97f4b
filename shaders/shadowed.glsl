// SPDX-License-Identifier: MIT
// SHADOWED: the scene has shadows (scene.glsl). They affect only the sun, the first enabled light. Vertex shaders
// output its part separately only then, as varyings are costly.
// LIGHTS: the numbers of the enabled lights; default: light 0.
#pragma import_defines(LIGHTS, SHADOW_MAP, SHADOW_MAPS, SHADOW_SLICES)

#if defined(SHADOW_MAP) || defined(SHADOW_MAPS) || defined(SHADOW_SLICES)
#define SHADOWED
#endif

#ifndef LIGHTS
#define LIGHTS 0
#endif

#ifndef SUN
// Not a loop over all eight lights: without unrolling it would compute disabled lights, too.
const int lights[] = int[](LIGHTS);
#define SUN lights[0]

/// Share of the sun's light that is not blocked in shadows within a crown or wood: leaves have scattered it, or it is
/// penumbra. @param left mean share that leaves leave there.
float softShare(float left) { return 0.5 * left * (1.0 - left) * (1.0 - left); }
#endif
