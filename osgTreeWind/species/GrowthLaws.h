// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeSize.h>
#include <osgTreeWind/species/Species.h>

namespace osgTreeWind {

// Allometry: properties of a tree from its height and diameter. docs/validation.md has the sources.

/// Adds a missing crown width, computed from the trunk diameter if that is given.
TreeSize withCrown(TreeSize size, const CrownAllometry& crown, bool openGrown);

/// Diameter to use in a law, metres. Laws are fitted to trees up to 1 m, and thicker trees are hardly higher
/// or wider: beyond 1 m it approaches 2 m.
double lawDiameter(double diameter);

/// The size of a tree, but at most the record of its species. @param largest 0 if unknown.
float limitToRecord(float size, float largest);

/// Adds all missing sizes for a species that grows by light: trunk and crown from the height, and the height
/// from the trunk, by the laws of the species if it has them, otherwise in proportion. For other species, and
/// without height and trunk diameter, the same as withCrown().
TreeSize completeSize(TreeSize size, const Species& species, bool openGrown);

/// Parameters of a typical tree of a species. In the open they are those of the species. In a forest, a
/// species that grows by light has a narrower crown, shading neighbours, and a longer clean stem if the
/// species' law of the crown depth gives one.
TreeParameters growthOf(const Species& species, bool openGrown);
/// The same for a tree of a given height, of a species that grows by light: trunk and crown follow from the
/// height by the laws of the species if it has them, otherwise in proportion.
/// @param height metres. @param atEdge whether the tree stands at the edge of the forest, open towards +x.
TreeParameters growthOf(const Species& species, bool openGrown, bool atEdge, float height);
/// Whether the species has GrowthParameters and no scans.
bool growsByLight(const Species& species);

/// Height of a tree of the species without a given size, metres; 0 if unknown.
float usualHeight(const Species& species);

/// Elastic modulus of a living trunk, Pa: that of clear wood, reduced by knots and juvenile wood, and lower
/// for stout trunks. @param slenderness height / diameter at breast height.
double stemModulus(const WoodParameters& wood, double slenderness);

/// Mass of all branch wood with bark and of the limbs into which a trunk divides, kg.
/// @param diameter at breast height, metres. @param height of the tree, metres. @param trunk mass of the
/// trunk, kg. @param drawn mass of the branches of the model, kg.
double branchWoodMass(const WoodParameters& wood, double diameter, double height, double trunk, double drawn);

/// Moment at the foot of a trunk that overturns the tree, N m: proportional to the mass of the stem. 0 if the
/// ground is rigid.
/// @param diameter at breast height, metres. @param height metres.
double overturningMoment(const WoodParameters& wood, double diameter, double height);

/// Moment that breaks a stem, N m; 0 if unknown (Gardiner et al. 2000).
/// @param diameter with bark at the place of the moment, metres.
double breakingMoment(const WoodParameters& wood, double diameter);

/// Strain of the outermost wood per bending moment, 1/(N m). @param modulus elastic modulus, Pa.
/// @param diameter at the place of the moment, metres.
double strainPerMoment(double modulus, double diameter);

/// Rotational compliance of roots and soil at the foot of a trunk, rad/(N m).
double rootCompliance(const WoodParameters& wood, double diameter, double height);

} // namespace osgTreeWind
