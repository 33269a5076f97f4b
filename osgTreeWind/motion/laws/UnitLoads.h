// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeModel.h>
#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

#include <vector>

namespace osgTreeWind {

/// What one unit bears by itself and what holds it, SI units.
struct UnitLoad {
    float woodMass = 0.0f;  ///< Of the unit itself, fresh, with bark, kg.
    float shootMass = 0.0f; ///< Of the shoots that ride on it, likewise.
    float leafArea = 0.0f;  ///< m^2.
    float leafMass = 0.0f;  ///< Fresh, kg.
    float woodDrag = 0.0f;  ///< CdA that keeps its form, m^2.
    float leafDrag = 0.0f;  ///< CdA that streamlines, at 10 m/s: of leaves, or of the measured crown, m^2.
    float modulus = 1.0f;   ///< Of its section as if it were all wood, Pa.
    float rootGive = 0.0f;  ///< Of what holds its base, rad/(N m): roots and soil under a trunk, else 0.
    float stiffness = 1.0f; ///< K of the joint at its base (jointStiffness()) and of its roots, N m/rad.

    float mass() const { return woodMass + shootMass + leafMass; } ///< Kg.
};

/// Loads of every unit of a tree. Leaves, and the drag of a crown that was measured, are where leaves are
/// drawn, by the area of their clusters.
/// @param leaves share of its leaves that the tree bears, 0 bare to 1; bare wood has a drag of its own, all
/// branches of it.
std::vector<UnitLoad> makeUnitLoads(const TreeModel& model, const TreeScale& scale, const Species& species,
                                    float leaves = 1.0f);

/// The same as far as the air goes, in a fraction of the time: areas and drags alone are right.
std::vector<UnitLoad> makeAirLoads(const TreeModel& model, const TreeScale& scale, const Species& species,
                                   float leaves = 1.0f);

/// Stiffness over angle of one unit, N m/rad: the joint at its base that moves the tip of its axis as the
/// bent wood of the unit would under a force there (Euler-Bernoulli, round section, diameter linear from d0
/// to d1): K = R^2 / integral of (R - s)^2 / (E I(s)) ds. For the last unit of an axis, R = length, it is 3
/// pi E d0^3 d1 / (64 length).
/// @param reach R, base of the unit to the tip of its axis, metres, >= length.
double jointStiffness(double elasticModulus, double d0, double d1, double length, double reach);

/// Diameter of its trunk at breast height, metres.
double breastDiameter(const TreeModel& model, const TreeScale& scale);

/// Area of all leaves of a tree, m^2.
float leafArea(const TreeModel& model, const TreeScale& scale, const Species& species, float leaves = 1.0f);

} // namespace osgTreeWind
