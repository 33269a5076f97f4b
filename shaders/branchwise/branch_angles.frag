// SPDX-License-Identifier: MIT
// The branch pass (thesis §5.2, appendix B): computes the next state of a branch unit from its previous state, the wind
// at its base and its parameters. osgTreeWind/gpu/branchwise/ForestAnglePasses.cpp packs the texels.

#include "data.glsl"
#include "target.glsl"
#include "real.glsl"
#include "law/limits.glsl"
#include "law/elementary.glsl"
#include "law/noise.glsl"
#include "law/rotation.glsl"
#include "law/thesis_branch.glsl"

uniform sampler2D previousAngles;   // one texel per unit: its state
uniform sampler2D wind;             // one texel per unit: m/s in the tree's frame, Z up
uniform sampler2D branchParameters; // three texels per unit
uniform sampler2D speciesTexels;    // four texels per species; the first: noise time of branches
uniform int motionLaw;              // MotionLaw

/// @param source species, seed (two halves), index in its tree.
vec3 thesisNoise(vec4 source) {
    vec4 time = dataTexel(speciesTexels, 4 * int(source.x + 0.5));
    uint seed = wholeNumber(source.yz);
    uint unit = uint(source.w + 0.5);
    uint cell = wholeNumber(time.xy);
    return vec3(motionNoise(noiseStream(seed, unit, 0u), cell, time.z, time.w),
                motionNoise(noiseStream(seed, unit, 1u), cell, time.z, time.w),
                motionNoise(noiseStream(seed, unit, 2u), cell, time.z, time.w));
}

out vec4 nextState;

void main() {
    int unit = targetIndex(previousAngles);
    vec4 state = dataTexel(previousAngles, unit);
    vec3 air = dataTexel(wind, unit).xyz;
    vec4 a = dataTexel(branchParameters, 3 * unit);
    vec4 b = dataTexel(branchParameters, 3 * unit + 1);
    vec4 c = dataTexel(branchParameters, 3 * unit + 2);

    // The order of the constructor's arguments is that of the packed fields.
    ThesisBranch branch = ThesisBranch(a.x, a.y, a.z, a.w, b.x);
    vec3 thesisAir = vec3(air.x, air.z, -air.y);
    vec3 noise = thesisNoise(c);
    nextState = motionLaw == 0 ? thesisBranchStep(state, thesisAir, noise, branch)
                                  : thesisSmoothBranchStep(state, thesisAir, noise, branch);
}
