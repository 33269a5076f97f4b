// SPDX-License-Identifier: MIT
// Needs limits.glsl. The leaf law of the thesis, appendix D as published; angles in radians.

/// Parameters of a leaf cluster, packed in this order (osgTreeWind/gpu/branchwise/ForestAnglePasses.cpp).
struct ThesisLeaf {
    float maxAngleX;    // maxMotionAngleX, [0, pi/2]
    float maxAngleZ;    // maxMotionAngleZ, [0, pi/2]
    float maxRotation;  // maxRotationAngle
    float partialSteps; // NUM, >= 1
    float factor;       // fact, (0, 1]
    float linkedFactor;
};

/// setPartialAngle of the listing: moves part of the way from `angle` to `target`. Limits the result by `fall` if the
/// angle decreases and by `rise` if it increases, for either axis.
float leafPartialAngle(float angle, float target, float steps, float fall, float rise) {
    float result = target;
    if (angle > result) result = bounded(angle - (angle - result) / steps, fall);
    if (angle < result) result = bounded(angle + (result - angle) / steps, rise);
    return result;
}

/// One frame. State and result: (motionAngleX, motionAngleZ, totalRotaAngle, noiseX). Noise in [-1, 1]. A noise of
/// exactly 0 becomes 1 and sets the target of the other axis to 0.01, unless both are 0.
vec4 thesisLeafStep(vec4 state, float noiseX, float noiseZ, ThesisLeaf leaf) {
    float n1 = bounded(noiseX, 1.0f);
    float n2 = bounded(noiseZ, 1.0f);
    bool setX = n1 == 0.0f || n2 != 0.0f;
    bool setZ = n2 == 0.0f || n1 != 0.0f;
    if (n1 == 0.0f) n1 = 1.0f;
    if (n2 == 0.0f) n2 = 1.0f;

    float rise = angleLimit(leaf.maxAngleX);
    float fall = angleLimit(leaf.maxAngleZ);
    float factor = bounded(leaf.factor, 1.0f);
    float targetX = 0.01f;
    float targetZ = 0.01f;
    if (setX) targetX = rise * n1 * factor;
    if (setZ) targetZ = fall * n2 * factor;
    float target = bounded(leaf.maxRotation, largest()) * (n1 + n2) / 2.0f +
                   bounded(leaf.linkedFactor, largest()) * targetX;

    float limit = max(rise, fall);
    float steps = stepCount(leaf.partialSteps);
    return vec4(leafPartialAngle(bounded(state.x, limit), targetX, steps, fall, rise),
                leafPartialAngle(bounded(state.y, limit), targetZ, steps, fall, rise),
                leafPartialAngle(bounded(state.z, limit), target, steps, fall, rise), bounded(noiseX, 1.0f));
}
