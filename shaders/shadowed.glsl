// SPDX-License-Identifier: MIT
// SHADOWED: the scene hands shadows down (scene.glsl), which take the light of the sun, the first light that is on, and leave
// the rest. Only then do vertex shaders hand both on apart, as varyings cost.
// LIGHTS: the numbers of those that are on; light 0 where nobody says.
#pragma import_defines(LIGHTS, SHADOW_MAP, SHADOW_MAPS)

#if defined(SHADOW_MAP) || defined(SHADOW_MAPS)
#define SHADOWED
#endif
#ifndef LIGHTS
#define LIGHTS 0
#endif

#ifndef SUN
// No loop over all eight: compilers that do not unroll it compute those that are off too.
const int lights[] = int[](LIGHTS);
#define SUN lights[0]
#endif
