// SPDX-License-Identifier: MIT
// Needs limits.glsl, elementary.glsl and oscillator.glsl. Law `modal`: a tree sways in a few modes, q'' + 2 rate q' +
// pace^2 q = force, and the air acts on a few patches of its crown, F = brake (v - u).

/// A component of the wind, m/s; 0 for NaN and beyond 200 m/s.
real plausibleWind(real x) { return abs(x) <= 200.0f ? x : every(0.0f); }

/// 1 for a patch that swings in still air, 0 for a patch at rest. @param wind, own squares of the speeds.
real swinging(real wind, real own) { return own / (own + wind + 1.0e-6f); }

/// Coefficient of the drag between a patch and the air, kg/s. In still air all leaves act with their full area as they
/// swing; in a wind, the crown shelters itself.
/// @param windDrag, stillDrag half the density of air times CdA, kg/m. @param swings swinging().
/// @param relative square of the speed of the air relative to the patch.
real airBrake(real windDrag, real stillDrag, real swings, real relative) {
    return (windDrag + max(stillDrag - windDrag, every(0.0f)) * swings) * sqrt(relative);
}

/// e^x within 1 % for x in [-0.5, 0.5]; limited to [1/3, 3].
real nearExponential(real x) {
    real by = min(max(0.5f * x, every(-0.5f)), every(0.5f));
    return (1.0f + by) / (1.0f - by);
}

/// Remaining share of a mode's stiffness under the tree's weight, [0.25, 2]; 0.25 halves the frequency.
/// @param taken share of the stiffness that the weight cancels.
real weightLeaves(real taken) { return 1.0f - max(min(taken, every(0.75f)), every(-1.0f)); }

/// Sets tiny values to zero, as denormal numbers are slow.
real settled(real x) { return abs(x) < 1.0e-12f ? every(0.0f) : x; }

/// Advances a mode by h seconds.
/// @param force at the start, including the drag. @param brake the part of the drag that depends on the mode's speed
/// during the step, 1/s. @param limit of the amplitude.
Swing modeStep(Swing start, real force, real brake, real pace, real dampingRatio, real limit, real h) {
    real middle = (force + brake * start.speed) / (pace * pace);
    Swing swing;
    swing.angle = start.angle - middle;
    swing.speed = start.speed;
    swing = swungFreely(swing, pace, dampingRatio * pace + 0.5f * brake, h);
    real angle = bounded(middle + swing.angle, limit);
    real fastest = limit * pace;
    real speed = bounded(swing.speed, fastest + fastest);
    speed = angle >= limit ? min(speed, every(0.0f)) : speed;
    speed = angle <= -limit ? max(speed, every(0.0f)) : speed;
    swing.angle = settled(angle);
    swing.speed = settled(speed);
    return swing;
}
