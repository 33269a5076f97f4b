// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

#include <vector>

namespace osgTreeWind {

/// Masses, drag and stiffness of one unit, SI units.
struct UnitLoad {
    float woodMass = 0.0f;  ///< Of the unit itself, fresh, with bark, kg.
    float shootMass = 0.0f; ///< Of the shoots on it, fresh, with bark, kg.
    float leafArea = 0.0f;  ///< m^2
    float leafMass = 0.0f;  ///< Fresh, kg.
    float woodDrag = 0.0f;  ///< CdA without streamlining, m^2.
    float leafDrag = 0.0f;  ///< CdA with streamlining, at 10 m/s, of the leaves or of a measured crown, m^2.
    float modulus = 1.0f;   ///< Effective elastic modulus of the full section, Pa.
    float rootCompliance =
        0.0f;               ///< Rotational compliance of roots and soil below the trunk, rad/(N m); else 0.
    float stiffness = 1.0f; ///< K of the base joint (jointStiffness()) and its roots, N m/rad.

    float mass() const { return woodMass + shootMass + leafMass; } ///< kg
};

/// Loads of all units of a tree. Leaves, and the drag of a measured crown, are distributed over the leaf
/// clusters by their area. @param leaves share of its leaves that the tree bears, 0 (bare) to 1. Bare wood
/// has the drag of all its branches.
std::vector<UnitLoad> makeUnitLoads(const TreeModel& model, const TreeScale& scale, const Species& species,
                                    float leaves = 1.0f);

/// Like makeUnitLoads() in a fraction of the time, but only areas and drags are valid.
std::vector<UnitLoad> makeAirLoads(const TreeModel& model, const TreeScale& scale, const Species& species,
                                   float leaves = 1.0f);

/// Rotational stiffness of one unit's base joint, N m/rad. The joint deflects the tip of the axis as the bent
/// wood of the unit would under a force at that tip (Euler-Bernoulli, round section, diameter linear from d0
/// to d1): K = R^2 / integral of (R - s)^2 / (E I(s)) ds. For the last unit of an axis (R = length), K = 3 pi
/// E d0^3 d1 / (64 length).
/// @param reach R, distance from the base of the unit to the tip of its axis, metres, >= length.
double jointStiffness(double elasticModulus, double d0, double d1, double length, double reach);

/// Trunk diameter at breast height, metres.
double breastDiameter(const TreeModel& model, const TreeScale& scale);

/// Total leaf area of a tree, m^2.
float leafArea(const TreeModel& model, const TreeScale& scale, const Species& species, float leaves = 1.0f);

} // namespace osgTreeWind
