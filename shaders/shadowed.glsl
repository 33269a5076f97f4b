// SPDX-License-Identifier: MIT
// SHADOWED: the scene hands shadows down (scene.glsl), which take the light of the sun, the first light that is on, and leave
// the rest. Only then do vertex shaders hand both on apart, as varyings cost.
#pragma import_defines(LIGHT_MASK, SHADOW_MAP, SHADOW_MAPS)

#if defined(SHADOW_MAP) || defined(SHADOW_MAPS)
#define SHADOWED
#endif
#ifndef LIGHT_MASK
#define LIGHT_MASK 1
#endif

bool isOn(int light) { return (LIGHT_MASK >> light & 1) != 0; }
bool isSun(int light) { return ((LIGHT_MASK & -LIGHT_MASK) >> light & 1) != 0; }
