// SPDX-License-Identifier: MIT
// Input of the pose passes of the law `modal`, packed by osgTreeWind/gpu/PosePass.cpp.

uniform sampler2D poseRequests; // one row per tree: PoseRequest
uniform sampler2D treeUnits;    // two texels per unit of the shape: base, parent; tip
uniform int unitCount;
uniform int unitRows; // rows of the target per tree, with up to 2048 units each

vec4 request(int tree, int texel) { return texelFetch(poseRequests, ivec2(texel, tree), 0); }

/// First texel of the tree's matrix, texels per row of the matrix, maximum angle.
vec3 matrixOf(int tree) { return request(tree, 0).xyz; }
vec3 axesOf(int tree) { return request(tree, 1).xxy; }
/// Foliage: exponents of streamlining above and below 10 m/s, its upper limit of the wind speed, maximum pull.
vec4 foliageOf(int tree) { return vec4(request(tree, 0).w, request(tree, 26).x, request(tree, 1).zw); }
const int mostFallen = 4;
/// A fallen part: horizontal rotation vector, and the unit about whose base it turns; zeros for no part.
vec4 fallenPart(int tree, int part) { return request(tree, 27 + part); }
vec4 shortVector(int tree, int texel) { return request(tree, 2 + texel); }
/// Wind at a patch of the crown, in the tree's axes, m/s.
vec3 patchWind(int tree, int patchIndex) { return request(tree, 14 + patchIndex).xyz; }

/// Tree and unit of a fragment; the fragment is unused if unit >= unitCount.
ivec2 treeAndUnit() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return ivec2(at.y / unitRows, (at.y % unitRows << 11) + at.x);
}

ivec2 texelOfUnit(int tree, int unit) {
    return ivec2(unit & 2047, tree * unitRows + (unit >> 11));
}
