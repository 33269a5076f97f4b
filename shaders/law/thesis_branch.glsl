// SPDX-License-Identifier: MIT
// Needs limits.glsl. The branch laws of the thesis: appendix B as published, and the text of §3.1.
// Axes of the thesis (Y up) in the tree's own frame; angles in radians.

/// bounded() per component.
vec3 boundedVector(vec3 v, float limit) {
    return vec3(bounded(v.x, limit), bounded(v.y, limit), bounded(v.z, limit));
}

/// Parameters of a branch, packed in this order (osgTreeWind/gpu/branchwise/ForestAnglePasses.cpp).
struct ThesisBranch {
    float spring;       // k of the cantilever, N/m
    float branchLength; // base to tip, metres
    float maxAngle;     // [0, pi/2]
    float partialSteps; // NUMB, >= 1
    float levelLoad;    // factor * branchLevel (§3.1.2)
};

/// Stiffness k of a rectangular cantilever (§3.1.1), N/m: E in Pa, lengths in metres.
float cantileverSpring(float elasticModulus, float width, float thickness, float span) {
    return (elasticModulus * width * thickness * thickness * thickness) / (4.0f * span * span * span);
}

/// Load on an axis; maxBranchLoad of the thesis is 0.01. A noise of zero counts as 1, even in a calm.
float thesisLoad(float wind, float loadNoise, bool calm) {
    if (abs(loadNoise) < 0.00001f) return wind + 0.01f;
    if (calm) return 0.0f;
    return wind + 0.01f * loadNoise;
}

/// Angles from deflection over length (angleSetBranch of appendix B).
vec3 thesisMotion(vec3 load, ThesisBranch branch) {
    vec3 share = load / branch.spring / branch.branchLength * vec3(0.7f, 0.6f, 0.8f);
    share = boundedVector(share, largest());
    if (share.x > 1.0f || share.y > 1.0f || share.z > 1.0f) {
        return vec3(arcSine(0.6f), arcSine(0.5f), arcSine(0.3f));
    }
    // The listing also computes asin of shares below -1, which are clamped here.
    vec3 sine = boundedVector(share, 1.0f);
    vec3 motion = vec3(arcSine(sine.x), arcSine(sine.y), arcSine(sine.z));
    return boundedVector(motion, angleLimit(branch.maxAngle));
}

/// Law `thesis`: one frame. State and result: (angleXY, angleYZ, wind.x, wind.z). As published, there is no restoring
/// force, and partialSteps and levelLoad are not used. Noise per axis in [-1, 1].
vec4 thesisBranchStep(vec4 state, vec3 wind, vec3 loadNoise, ThesisBranch branch) {
    vec3 air = boundedVector(wind, largest());
    vec3 n = boundedVector(loadNoise, 1.0f);
    vec3 load = vec3(thesisLoad(air.x, n.x, air.x == 0.0f), thesisLoad(air.y, n.y, air.y == 0.0f),
                     thesisLoad(air.z, n.z, abs(air.z) < 0.00001f));
    vec3 motion = thesisMotion(load, branch);
    float limit = angleLimit(branch.maxAngle);
    return vec4(bounded(bounded(state.x, limit) + motion.x, limit),
                bounded(bounded(state.y, limit) + motion.z, limit), air.x, air.z);
}

/// Load on an axis with the level term as printed (§3.1.2). Zero without wind on this axis, as the constant terms would
/// move a branch in a calm.
float smoothLoad(float wind, float loadNoise, float levelLoad) {
    if (wind == 0.0f) return 0.0f;
    return wind + levelLoad + 0.01f * loadNoise;
}

/// Law `thesis-smooth`: as thesisBranchStep(), but the step covers only 1/partialSteps of the way to the new angle.
vec4 thesisSmoothBranchStep(vec4 state, vec3 wind, vec3 loadNoise, ThesisBranch branch) {
    vec3 air = boundedVector(wind, largest());
    vec3 n = boundedVector(loadNoise, 1.0f);
    float level = bounded(branch.levelLoad, largest());
    vec3 load = vec3(smoothLoad(air.x, n.x, level), smoothLoad(air.y, n.y, level),
                     smoothLoad(air.z, n.z, level));
    vec3 motion = thesisMotion(load, branch);
    float limit = angleLimit(branch.maxAngle);
    float steps = stepCount(branch.partialSteps);
    float angleXY = bounded(state.x, limit);
    float angleYZ = bounded(state.y, limit);
    return vec4(angleXY + (bounded(angleXY + motion.x, limit) - angleXY) / steps,
                angleYZ + (bounded(angleYZ + motion.z, limit) - angleYZ) / steps, air.x, air.z);
}
