// SPDX-License-Identifier: MIT
// Bark: vertices are at a distance `radius` from the centre line of the branch.
// osg_Vertex: centre, radius; osg_Normal: outward; osg_MultiTexCoord0: u (0 to 2 around), v, unit;
// osg_MultiTexCoord1: shade (law/shade.glsl).

#include "branchwise/tree.glsl"
#include "light.glsl"
#include "surface.glsl"

uniform float treeOwn; // number of the tree, [0, 1)

out vec3 barkCoord; // bark_texture.glsl
out vec2 barkGirth; // radius of the wood and its height above the ground, m
out float barkCover; // share of its pixels that the wood covers
out vec3 barkLight;
out vec3 scenePosition;

void main() {
    UnitPose pose = unitPose(int(osg_MultiTexCoord0.z));
    vec3 rest = treeAxes * osg_Vertex.xyz + treeSizes.x * osg_Vertex.w * osg_Normal;
    vec4 eyePosition = osg_ModelViewMatrix * vec4(turnVector(pose.rotation, rest) + pose.translation, 1.0);
    vec3 eyeNormal = normalize(osg_NormalMatrix * turnVector(pose.rotation, osg_Normal));

    Shade shade = Shade(unpackedShares(osg_MultiTexCoord1.x), unpackedShares(osg_MultiTexCoord1.y), vec2(1.0, 0.0), 1.0);
    barkCover = 1.0;
    barkLight = barkShade(eyePosition.xyz, eyeNormal, shade);
    barkCoord = vec3(osg_MultiTexCoord0.xy, osg_MultiTexCoord0.x - 2.0 * step(1.0, osg_MultiTexCoord0.x));
    barkGirth = vec2(treeSizes.x * osg_Vertex.w, treeAxes.z * osg_Vertex.z);
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeOwn);
}
