// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/motion/laws/PhysicalConstants.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>

#include <vector>

namespace osgTreeWind {

/// Stiffness over angle of one unit, N m/rad: the joint at its base that moves the tip of its axis as the
/// bent wood of the unit would under a force there (Euler-Bernoulli, round section, diameter linear from d0
/// to d1): K = R^2 / integral of (R - s)^2 / (E I(s)) ds. For the last unit of an axis, R = length, it is 3
/// pi E d0^3 d1 / (64 length).
/// @param reach R, base of the unit to the tip of its axis, metres, >= length.
double jointStiffness(double elasticModulus, double d0, double d1, double length, double reach);

/// Circular frequency at which each axis of a tree sways, rad/s, one per unit (units of one axis have the
/// same). An axis is a unit with the units of its level that carry it on: the trunk, a branch. It is held at
/// its base; everything upon it bends with it, wood as beams, leaves as mass along their unit, and
/// roots give under a trunk. Of its modes,
/// the one that takes the largest part when the axis is pulled and let go (Lanczos' method); mean of both
/// directions across. Weight slows what stands and quickens what hangs (Rayleigh's quotient of the pulled
/// axis).
/// @param loads of makeUnitLoads(). @param gravity m/s^2.
std::vector<double> axisPaces(const TreeModel& model, const TreeScale& scale,
                              const std::vector<UnitLoad>& loads, double gravity = osgTreeWind::gravity);

} // namespace osgTreeWind
