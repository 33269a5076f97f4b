// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace osgTreeWind {

/// The outline of a crown, by Weber and Penn 1995.
enum class CrownOutline {
    Cone,            ///< 0.2 + 0.8 r
    Sphere,          ///< 0.2 + 0.8 sin(pi r)
    Hemisphere,      ///< 0.2 + 0.8 sin(pi r / 2)
    Cylinder,        ///< 1
    TaperedCylinder, ///< 0.5 + 0.5 r
    Flame,           ///< r / 0.7 up to 0.7, then (1 - r) / 0.3
    InverseCone,     ///< 1 - 0.8 r
    TendFlame,       ///< 0.5 + 0.5 of the flame
};

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

} // namespace osgTreeWind
