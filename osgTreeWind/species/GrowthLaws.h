// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

// What height and diameter tell of a tree that nobody looked into. Sources: docs/validation.md.

/// The size with its crown's width where that is not given, but known from the diameter of the trunk.
TreeSize withCrown(TreeSize size, const CrownAllometry& crown, bool openGrown);

/// The size with all that is not given, of a species that grows by light: trunk and crown follow from the
/// height, and the height from the trunk, by the laws of the species where it has them, else in proportion.
/// Of other species, and where neither height nor trunk is given, as withCrown().
TreeSize wholeSize(TreeSize size, const Species& species, bool openGrown);

/// How trees of a species grow: with room on all sides as it says, in a forest with a crown of the depth that
/// its law has for its own height, where that is shallower. What the crown holds keeps its place in it:
/// boughs and leaves are as many, closer to each other; those below are gone.
TreeParameters growthOf(const Species& species, bool openGrown);
/// How trees of that height grow, of a species that grows by light: their trunks and crowns follow from
/// the height by the laws of the species, where it has them, else in proportion.
/// @param height metres. @param atEdge of a forest, which is open towards +x.
TreeParameters growthOf(const Species& species, bool openGrown, bool atEdge, float height);
/// Whether trees of the species grow by light (GrowthParameters) and are no scans.
bool growsByLight(const Species& species);

/// Height to which a species grows when no size of a tree is given, metres. 0: the species does not say.
float usualHeight(const Species& species);

/// Modulus of a living trunk: that of clear wood, less what knots and young wood take, and less where it is
/// stout for its height, Pa.
/// @param slenderness height over diameter at breast height.
double stemModulus(const WoodParameters& wood, double slenderness);

/// Mass of all branch wood with its bark, kg.
/// @param diameter of the trunk at breast height, metres. @param height of the tree, metres. @param trunk its
/// mass, kg. @param drawn mass of the branches of the model, kg.
double branchWoodMass(const WoodParameters& wood, double diameter, double height, double trunk, double drawn);

/// Moment at the foot of a trunk that overturns the tree, in proportion to the mass of its stem, N m; 0: it
/// stands on rock.
/// @param diameter at breast height, metres. @param height metres.
double overturningMoment(const WoodParameters& wood, double diameter, double height);

/// Moment that breaks a stem where it has that diameter, bark and all (metres), N m; 0: not known. Gardiner
/// et al. 2000.
double breakingMoment(const WoodParameters& wood, double diameter);

/// How far roots and soil let the foot of a trunk turn, rad/(N m).
double rootGive(const WoodParameters& wood, double diameter, double height);

} // namespace osgTreeWind
