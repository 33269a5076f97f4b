// SPDX-License-Identifier: MIT
// What the passes of the law `modal` know of the trees they pose; packed by osgTreeWind/gpu/PosePass.cpp.

uniform sampler2D poseRequests; // a row a tree, see below
uniform sampler2D treeUnits;    // two texels a unit of the shape: base, parent; tip
uniform int unitCount;
uniform int unitRows; // of the target that a tree takes, each of up to 2048 units

vec4 request(int tree, int texel) { return texelFetch(poseRequests, ivec2(texel, tree), 0); }

/// First texel of the tree's matrix, texels of one of its rows, largest angle.
vec3 matrixOf(int tree) { return request(tree, 0).xyz; }
vec3 axesOf(int tree) { return request(tree, 1).xxy; }
/// Of its foliage: exponents of streamlining from and below 10 m/s, the speed up to which that holds, pull in a storm.
vec4 foliageOf(int tree) { return vec4(request(tree, 0).w, request(tree, 26).x, request(tree, 1).zw); }
const int mostFallen = 4;
/// A part that has come down: level rotation vector, and the unit about whose base it has turned; 0 for none.
vec4 fallenPart(int tree, int part) { return request(tree, 27 + part); }
vec4 shortVector(int tree, int texel) { return request(tree, 2 + texel); }
/// In the tree's own axes, m/s.
vec3 patchWind(int tree, int patchIndex) { return request(tree, 14 + patchIndex).xyz; }

/// Tree and unit that a fragment stands for; unit >= unitCount: none.
ivec2 treeAndUnit() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    return ivec2(at.y / unitRows, (at.y % unitRows << 11) + at.x);
}

ivec2 texelOfUnit(int tree, int unit) {
    return ivec2(unit & 2047, tree * unitRows + (unit >> 11));
}
