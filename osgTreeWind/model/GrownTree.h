// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/CrownOutline.h>
#include <osgTreeWind/model/Skeleton.h>

#include <array>
#include <cstdint>

namespace osgTreeWind {

/// Branches of one level of a grown tree. Angles in radians; ranges: TreeFields.h.
struct GrownBranches {
    int count = 8;       ///< Boughs: of the tree, others: of the longest that bears them.
    int units = 1;       ///< In line.
    float start = 0.2f;  ///< Share of the one that bears them below the first; boughs: crownBase instead.
    float length = 1.0f; ///< Boughs: over the way to the outline; others: over Lparent - 0.6 offset.
    float lengthVariation = 0.2f;       ///< Random part of the length, which it shortens.
    float inclination = 1.0f;           ///< Of the first, from what bears them.
    float inclinationEnd = 0.7f;        ///< Of the last.
    float inclinationVariation = 0.15f; ///< Largest random part.
    float flat = 0.0f;                  ///< 0: on all sides of what bears them; 1: to its left and right.
    float rise = 0.0f;                  ///< By which the inner half turns up, or down.
    float riseOutside = 0.0f;           ///< Likewise the outer half.
    float crook = 0.15f;                ///< How far it winds.
    float sections = 1.0f; ///< Cross-sections of all over that of what bears them; 1: Leonardo's rule.
    float power = 1.0f;    ///< Radius of sisters as length^power.
    float taper = 0.4f;    ///< Radius at the tip over that at the base.
};

/// Parameters of a tree with branches along their parents and a crown of a given outline, after Weber and
/// Penn 1995, Creation and Rendering of Realistic Trees. Lengths in metres, angles in
/// radians; ranges: TreeFields.h.
struct GrownTreeParameters {
    float height = 15.0f;         ///< Of the tree.
    float radius = 0.2f;          ///< Of the trunk at the ground.
    float trunk = 0.75f;          ///< Height of the trunk over that of the tree.
    int trunkUnits = 4;           ///< In line.
    float trunkTaper = 0.5f;      ///< Radius at its top over that at the ground; linear between.
    float trunkCrook = 0.05f;     ///< How far it winds.
    float flare = 0.0f;           ///< How much wider its bark is at the ground, over its radius: StemFoot.h.
    int forks = 3;                ///< Boughs that spring from the very end of the trunk.
    float forkInclination = 0.4f; ///< Their angle from the trunk.
    CrownOutline shape = CrownOutline::Sphere; ///< Of the crown.
    float crownBase = 0.3f;                    ///< Height of the lowest bough over that of the tree.
    float crownWidth = 10.0f;  ///< Where it is widest, at most 4 heights, at least 0.01 of it.
    int whorl = 1;             ///< Boughs at about one height.
    GrownBranches boughs{12};  ///< Of the trunk.
    GrownBranches branches{8}; ///< Of each bough.
    GrownBranches twigs{2};    ///< Of each branch.
    int ringsPerBranch = 8;    ///< Points of each unit.
    std::uint32_t seed = 1;    ///< One seed gives one tree, bit for bit, on every machine.
};

/// The parameters with every value brought into its range; NaN becomes the default. Twigs, then branches are
/// left out until the skeleton has at most maxSkeletonPoints.
GrownTreeParameters clamped(GrownTreeParameters parameters);

/// Grows a skeleton: a trunk (level 0) with boughs along it (1) that reach to the outline of the crown,
/// branches along these (2), twigs along those (3). Boughs hang at most a quarter of the crown's width below
/// its base, and not into the ground. Azimuths are uniform. Out-of-range parameters are clamped().
Skeleton makeGrownTree(const GrownTreeParameters& parameters);

} // namespace osgTreeWind
