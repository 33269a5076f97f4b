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
#endif
