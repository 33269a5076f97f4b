// SPDX-License-Identifier: MIT
// The leaf pass (thesis §5.2, appendix D): computes the next angles of a leaf cluster from its previous angles.
// osgTreeWind/gpu/branchwise/ForestAnglePasses.cpp packs the texels.

#include "data.glsl"
#include "target.glsl"
#include "real.glsl"
#include "law/limits.glsl"
#include "law/noise.glsl"
#include "law/thesis_leaf.glsl"

uniform sampler2D previousAngles; // one texel per leaf cluster: its state
uniform sampler2D leafParameters; // one texel per leaf cluster: species, seed (two halves), index in the tree
uniform sampler2D speciesTexels;  // four texels per species; the second: noise time of leaves, then their motion

out vec4 nextState;

void main() {
    int leaf = targetIndex(previousAngles);
    vec4 own = dataTexel(leafParameters, leaf);
    int species = 4 * int(own.x + 0.5);
    vec4 time = dataTexel(speciesTexels, species + 1);
    vec4 a = dataTexel(speciesTexels, species + 2);
    vec4 b = dataTexel(speciesTexels, species + 3);

    uint seed = wholeNumber(own.yz);
    uint index = uint(own.w + 0.5);
    uint cell = wholeNumber(time.xy);
    float x = motionNoise(noiseStream(seed, index, 3u), cell, time.z, time.w);
    float z = motionNoise(noiseStream(seed, index, 4u), cell, time.z, time.w);
    nextState = thesisLeafStep(dataTexel(previousAngles, leaf), x, z,
                                  ThesisLeaf(a.x, a.y, a.z, a.w, b.x, b.y));
}
