// SPDX-License-Identifier: MIT
// Needs limits.glsl, elementary.glsl, oscillator.glsl and rotation.glsl. Law `damped`: a driven oscillator per branch and axis, SI
// units, independent of the frame rate and stable at any step.
// J w' + (C + b l^2) w + K x = b l v,  b = drag |v - l w|

/// What a branch is to this law; packed as it stands (osgTreeWind/gpu/branchwise/LawTexels.cpp).
struct DampedBranch {
    float stiffness;     // K of the joint at its base, N m/rad
    float inertia;       // J, kg m^2: K over the square of its axis' own speed
    float damping;       // C = 2 dampingRatio sqrt(K J), N m s
    float drag;          // half the air's density times the sum of CdA, kg/m, up to 10 m/s
    float lever;         // l of the drag: its speed over the joint's as the whole axis bends, metres
    float maxAngle;      // [0, pi/2]
    float streamlining;  // n: the drag falls as speed^-n
    float streamlinedTo; // between 10 m/s and this speed
    vec3 direction;      // base to tip at rest, unit length
    float windHeight;    // where its wind is taken: centre of the drag above the foot of the tree, metres
};

/// The same within ranges in which no step overflows.
DampedBranch soundBranch(DampedBranch given) {
    DampedBranch branch = given;
    branch.stiffness = max(bounded(given.stiffness, 1.0e12f), 1.0e-6f);
    branch.inertia = max(bounded(given.inertia, 1.0e12f), 1.0e-6f);
    branch.damping = max(bounded(given.damping, 1.0e9f), 0.0f);
    branch.drag = max(bounded(given.drag, 1.0e6f), 0.0f);
    branch.lever = max(bounded(given.lever, 1.0e3f), 0.0f);
    branch.maxAngle = angleLimit(given.maxAngle);
    branch.streamlining = max(bounded(given.streamlining, 2.0f), 0.0f);
    branch.streamlinedTo = max(bounded(given.streamlinedTo, 1.0e3f), 10.0f);
    return branch;
}

/// (angle, speed) after h seconds under the drag factor b held constant: the exact solution.
vec2 dampedExactStep(vec2 motion, float wind, float b, DampedBranch branch, float h) {
    float equilibrium = b * branch.lever * wind / branch.stiffness;
    float rate = (branch.damping + b * branch.lever * branch.lever) / (2.0f * branch.inertia);
    Swing swing;
    swing.angle = motion.x - equilibrium;
    swing.speed = motion.y;
    swing = swungFreely(swing, sqrt(branch.stiffness / branch.inertia), rate, h);
    return vec2(equilibrium + swing.angle, swing.speed);
}

/// One axis over h > 0 seconds: half a step to find the drag, a whole one with it, then the limit.
vec2 dampedAxisStep(vec2 motion, float wind, DampedBranch branch, float h) {
    float before = branch.drag * abs(wind - branch.lever * motion.y);
    vec2 middle = dampedExactStep(motion, wind, before, branch, 0.5f * h);
    float during = branch.drag * abs(wind - branch.lever * bounded(middle.y, 1.0e3f));
    vec2 next = dampedExactStep(motion, wind, during, branch, h);
    float angle = bounded(next.x, branch.maxAngle);
    float speed = bounded(next.y, 1.0e3f);
    if (angle >= branch.maxAngle) speed = min(speed, 0.0f);
    if (angle <= -branch.maxAngle) speed = max(speed, 0.0f);
    return vec2(angle, speed);
}

/// `seconds` of motion, at most 1, in substeps of at most 1/120 s; none for 0 or less. The wind goes evenly
/// from what it was at the start to what it is at the end.
/// State: angles about both axes, rad, then their speeds, rad/s. Winds: along both, m/s.
vec4 dampedBranchStep(vec4 state, vec2 windBefore, vec2 windNow, DampedBranch given, float seconds) {
    DampedBranch branch = soundBranch(given);
    DampedBranch streamlined = branch;
    float time = max(bounded(seconds, 1.0f), 0.0f);
    int steps = int(ceil(time * 120.0f - 0.001f));
    vec2 start = vec2(bounded(windBefore.x, 1.0e3f), bounded(windBefore.y, 1.0e3f));
    vec2 end = vec2(bounded(windNow.x, 1.0e3f), bounded(windNow.y, 1.0e3f));
    vec2 first = vec2(bounded(state.x, branch.maxAngle), bounded(state.z, 1.0e3f));
    vec2 second = vec2(bounded(state.y, branch.maxAngle), bounded(state.w, 1.0e3f));
    for (int i = 0; i < steps; ++i) {
        vec2 air = start + (float(i) + 0.5f) / float(steps) * (end - start);
        streamlined.drag = branch.drag * streamlinedShare(branch.streamlining, 0.0f, branch.streamlinedTo, length(air));
        first = dampedAxisStep(first, air.x, streamlined, time / float(steps));
        second = dampedAxisStep(second, air.y, streamlined, time / float(steps));
    }
    return vec4(first.x, second.x, first.y, second.y);
}

/// First axis of a branch, across its unit direction: nearest to +x (to +y for a branch along x).
vec3 branchAxis1(vec3 direction) {
    vec3 side = vec3(1.0f, 0.0f, 0.0f);
    if (abs(direction.x) > 0.99f) side = vec3(0.0f, 1.0f, 0.0f);
    return normalize(side - dot(side, direction) * direction);
}

/// Second axis; thesis +z for an upright branch.
vec3 branchAxis3(vec3 direction) { return cross(branchAxis1(direction), direction); }

/// The wind along both axes.
vec2 windAcross(vec3 air, vec3 direction) {
    vec3 axis1 = branchAxis1(direction);
    return vec2(dot(air, axis1), dot(air, cross(axis1, direction)));
}

/// Turn of a branch about its base: the rotation vector angle1 (d x e1) + angle3 (d x e3).
vec4 dampedRotation(float angle1, float angle3, vec3 direction) {
    vec3 turn =
        angle1 * cross(direction, branchAxis1(direction)) + angle3 * cross(direction, branchAxis3(direction));
    float angle = length(turn);
    if (angle < 1.0e-12f) return vec4(0.0f, 0.0f, 0.0f, 1.0f);
    return turnAbout(turn / angle, angle);
}
