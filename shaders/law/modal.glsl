// SPDX-License-Identifier: MIT
// Needs limits.glsl, elementary.glsl and oscillator.glsl. Law `modal`: a tree sways in a few modes, q'' + 2 rate q' +
// pace^2 q = force, and the air pushes on a few patches of its crown, F = brake (v - u).

/// A component of the wind, m/s; one that no wind on earth ever had, and what is no number, counts as calm.
real plausibleWind(real x) { return abs(x) <= 200.0f ? x : every(0.0f); }

/// 1 for a patch that swings in still air, 0 for one that stands still. @param wind, own squares of speeds.
real swinging(real wind, real own) { return own / (own + wind + 1.0e-6f); }

/// kg/s: what a patch and the air take from each other's speed. In still air leaves meet it with their whole area
/// as they swing; in a wind, with what the crown's own shelter leaves.
/// @param windDrag, stillDrag kg/m: half the air's density times CdA. @param swings share of a swing in still air.
/// @param relative square of the speed of the air past the patch.
real airBrake(real windDrag, real stillDrag, real swings, real relative) {
    return (windDrag + max(stillDrag - windDrag, every(0.0f)) * swings) * sqrt(relative);
}

/// e^x within 1 % for x in [-0.5, 0.5]; held within [1/3, 3].
real nearExponential(real x) {
    real by = min(max(0.5f * x, every(-0.5f)), every(0.5f));
    return (1.0f + by) / (1.0f - by);
}

/// Share of its stiffness that weight leaves a mode, given the share it takes: a tree that leans so far on its
/// stiffness still has half its pace.
real weightLeaves(real taken) { return 1.0f - max(min(taken, every(0.75f)), every(-1.0f)); }

/// What is too small to see comes to rest: numbers near the smallest of all make a processor slow.
real settled(real x) { return abs(x) < 1.0e-12f ? every(0.0f) : x; }

/// One mode over h seconds.
/// @param force that drives it at the start, what the air brakes included; @param brake that part of the brake which
/// follows the mode's own speed through the step, 1/s; @param limit of the amplitude.
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
