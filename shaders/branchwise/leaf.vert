// SPDX-License-Identifier: MIT
// A corner of a leaf cluster, rotated by its own angles, its rest orientation and its branch.
// osg_Vertex: anchor, size; osg_Normal: corner in the leaf frame; osg_MultiTexCoord0: u, v, unit, leaf;
// osg_MultiTexCoord1: rest orientation; osg_MultiTexCoord2: normal in the leaf frame, shade (law/shade.glsl);
// osg_MultiTexCoord3: outward direction in the crown, shade.

#include "branchwise/tree.glsl"
#include "law/tint.glsl"
#include "facing.glsl"
#include "light.glsl"
#include "surface.glsl"

uniform sampler2D leafAngles; // one texel per leaf: motionAngleX, motionAngleZ, totalRotaAngle
uniform float treeOwn;        // number of the tree, [0, 1)
uniform float treeLeaves;     // share of the leaves that the tree bears
uniform int treeFirstLeaf;    // first texel of the tree in leafAngles; negative: leaves at rest

out vec2 leafCoord;
out vec3 leafLight;
out vec3 scenePosition;
flat out int leafCard;
flat out float leafBorne; // 1: leaves, 0: bare twigs
out vec2 leafFacing; // facing.glsl

void main() {
    UnitPose pose = unitPose(int(osg_MultiTexCoord0.z));
    vec4 angles = vec4(0.0);
    if (treeFirstLeaf >= 0)
        angles = dataTexel(leafAngles, treeFirstLeaf + int(osg_MultiTexCoord0.w + 0.5));
    vec4 flutter = leafRotation(angles.x, angles.y, angles.z);

    vec3 corner = treeSizes.y * osg_Vertex.w * turnVector(osg_MultiTexCoord1, turnVector(flutter, osg_Normal));
    vec3 rest = treeAxes * osg_Vertex.xyz + corner;
    vec4 eyePosition = osg_ModelViewMatrix * vec4(turnVector(pose.rotation, rest) + pose.translation, 1.0);

    // Foliage is lit more like a crown than like single blades, from both sides, and transmits light.
    vec3 blade = turnVector(osg_MultiTexCoord1, turnVector(flutter, osg_MultiTexCoord2.xyz));
    vec3 crown = osg_MultiTexCoord3.xyz;
    vec3 normal = normalize(crown + 0.5 * sign(dot(blade, crown)) * blade);
    vec3 eyeNormal = normalize(osg_NormalMatrix * turnVector(pose.rotation, normal));
    Shade shade = Shade(unpackedShares(osg_MultiTexCoord2.w), unpackedShares(osg_MultiTexCoord3.w), vec2(1.0, 0.0), 1.0);
    leafBorne = fract(0.618034 * osg_MultiTexCoord0.w) < treeLeaves ? 1.0 : 0.0;
    vec3 own = mix(vec3(1.0), treeTint(treeOwn) * clusterTint(treeOwn, osg_MultiTexCoord0.w), leafBorne);
    vec3 eyeBlade = normalize(osg_NormalMatrix * turnVector(pose.rotation, blade));
    leafFacing = facingOf(abs(dot(eyeBlade, normalize(eyePosition.xyz))));
    leafLight = leafShade(eyePosition.xyz, eyeNormal, eyeBlade, shade);
    float glint = bladeGlint(
        osg_MultiTexCoord0.w,
        normalize(osg_NormalMatrix * turnVector(pose.rotation, turnVector(osg_MultiTexCoord1, osg_MultiTexCoord2.xyz))),
        eyeBlade);
    leafLight = own * (leafLight + (glint - 1.0) * sunLight);
    sunLight *= glint * own;

    leafCoord = osg_MultiTexCoord0.xy;
    leafCard = gl_VertexID / 4;
    scenePosition = eyePosition.xyz;
    placeSurface(eyePosition, eyeNormal, treeOwn);
}
