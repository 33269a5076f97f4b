// SPDX-License-Identifier: MIT
// Input of the pose passes of the law `modal`, packed by osgTreeWind/gpu/PosePass.cpp.

uniform sampler2D poseRequests; // one row per tree: PoseRequest
uniform sampler2D poseBlocks;   // one texel per 64 texels of the target: PosePage::Block
uniform sampler2D treeUnits;    // two texels per unit of all models: base, parent; tip

vec4 request(int tree, int texel) { return texelFetch(poseRequests, ivec2(texel, tree), 0); }

/// First texel of the tree's matrix, texels per row of the matrix, maximum angle.
vec3 matrixOf(int tree) { return request(tree, 0).xyz; }
vec3 axesOf(int tree) { return request(tree, 1).xxy; }
/// Foliage: exponents of streamlining above and below 10 m/s, its upper limit of the wind speed, maximum pull.
vec4 foliageOf(int tree) { return vec4(request(tree, 0).w, request(tree, 26).x, request(tree, 1).zw); }
/// First unit of the tree's model in treeUnits, and their number.
ivec2 unitsOf(int tree) { return ivec2(request(tree, 26).yz); }
const int mostFallen = 4;
/// A fallen part: horizontal rotation vector, and the unit about whose base it turns; zeros for no part.
vec4 fallenPart(int tree, int part) { return request(tree, 27 + part); }
vec4 shortVector(int tree, int texel) { return request(tree, 2 + texel); }
/// Wind at a patch of the crown, in the tree's axes, m/s.
vec3 patchWind(int tree, int patchIndex) { return request(tree, 14 + patchIndex).xyz; }

/// Tree and unit of a fragment; the fragment is unused if the tree has no such unit.
ivec2 treeAndUnit() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return ivec2(texelFetch(poseBlocks, ivec2(at.x >> 6, at.y), 0).xy) + ivec2(0, at.x & 63);
}
