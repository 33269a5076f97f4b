// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/Skeleton.h>

#include <cstdint>

namespace osgTreeWind {

/// The largest angle of a branch from the vertical: somewhat below the horizontal.
constexpr float maxInclination = 2.17f;

/// The most points a skeleton may have: 65,536 units of 16 rings, some 0.5 GB of skin.
constexpr std::uint64_t maxSkeletonPoints = 1u << 20;

/// Parameters of the recursive generator (thesis §2.2, §2.3.2). Lengths in metres, angles in
/// radians; ranges: TreeFields.h.
/// The defaults make the reference tree: 122 units, 1952 points.
struct RecursiveTreeParameters {
    int levels = 4;                  ///< `iter`: levels of branches above the trunk.
    int childrenPerBranch = 3;       ///< `numD`: branches at the end of each branch.
    int trunkUnits = 2;              ///< Units the trunk is made of.
    int bareUnits = 1;               ///< Lowest of them that end without branches; never the last.
    int ringsPerBranch = 16;         ///< `numBreaks`.
    float length = 1.2f;             ///< `leng`: length of one trunk unit.
    float boughLength = 0.6f;        ///< Length of a first branch over the whole trunk's.
    float lengthRatio = 0.85f;       ///< Length of any other branch over its parent's.
    float crownTaper = 1.0f;         ///< Length of the topmost first branches over the lowest.
    float inclination = 0.75f;       ///< `bendA`: angle of a branch from the vertical.
    float inclinationGrowth = 1.05f; ///< Factor on `inclination` from one level to the next.
    float leader = 0.5f;             ///< 0: all children lean alike (thesis); 1: one goes straight on.
    float follow = 0.85f;            ///< 0: angles from the vertical (thesis); 1: from the parent's axis.
    float twist = 0.7f;              ///< Azimuth by which each level is turned against the one below.
    float jitter = 0.3f;             ///< Random part of branch length and direction.
    float crook = 0.05f;             ///< Largest random offset of a break over branch length (§2.2.1).
    float radius = 0.15f;            ///< Trunk radius at the ground.
    float taper = 0.72f;       ///< Tip radius over base radius of the trunk, and of a branch; linear between.
    float radiusRatio = 0.78f; ///< Base radius of a branch over its parent's tip radius.
    std::uint32_t seed = 1;    ///< One seed gives one tree, bit for bit, on every machine.
};

/// The parameters with every value brought into its range; NaN becomes the default. `levels` is lowered
/// until the skeleton has at most maxSkeletonPoints.
RecursiveTreeParameters clamped(RecursiveTreeParameters parameters);

/// Trunk units that bear branches at their ends: 1 for the thesis' tree, more for a conifer.
/// @param parameters clamped() ones.
int branchingUnits(const RecursiveTreeParameters& parameters);

/// Grows a skeleton. Out-of-range parameters are clamped(). Branches shorter than 1e-4 and radii thinner than
/// 1e-5 of the tree's reach are brought up to that, so that no part of it degenerates.
Skeleton makeRecursiveTree(const RecursiveTreeParameters& parameters);

} // namespace osgTreeWind
