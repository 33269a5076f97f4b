// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/growth/GrowthParameters.h>
#include <osgTreeWind/model/PalmParameters.h>
#include <osgTreeWind/model/ScannedTree.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace osgTreeWind {

/// Parameters of the recursive generator (thesis §2.2, §2.3.2). Lengths in metres, angles in radians; ranges:
/// TreeKeys.h. The defaults make the reference tree: 122 units, 1952 points.
struct RecursiveTreeParameters {
    int levels = 4;                  ///< `iter`: levels of branches above the trunk.
    int childrenPerBranch = 3;       ///< `numD`: branches at the end of each branch.
    int trunkUnits = 2;              ///< Units the trunk is made of.
    int bareUnits = 1;               ///< Lowest trunk units, which end without branches; never the last.
    int ringsPerBranch = 16;         ///< `numBreaks`.
    float length = 1.2f;             ///< `leng`: length of one trunk unit.
    float boughLength = 0.6f;        ///< Length of a first-level branch over the whole trunk's.
    float lengthRatio = 0.85f;       ///< Length of any other branch over its parent's.
    float crownTaper = 1.0f;         ///< Length of the topmost first-level branches over the lowest.
    float inclination = 0.75f;       ///< `bendA`: angle of a branch from the vertical.
    float inclinationGrowth = 1.05f; ///< Factor on `inclination` from one level to the next.
    float leader = 0.5f;             ///< 0: all children lean alike (thesis); 1: one continues straight.
    float follow = 0.85f;            ///< 0: angles from the vertical (thesis); 1: from the parent's axis.
    float twist = 0.7f;              ///< Azimuth between successive levels.
    float jitter = 0.3f;             ///< Random part of branch length and direction.
    float crook = 0.05f;             ///< Largest random offset of a break over branch length (§2.2.1).
    float radius = 0.15f;            ///< Trunk radius at the ground.
    float taper = 0.72f;             ///< Tip radius over base radius, of the trunk and of a branch; linear.
    float radiusRatio = 0.78f;       ///< Base radius of a branch over its parent's tip radius.
    std::uint32_t seed = 1;          ///< Determines the tree, bit for bit, on every machine.
};

/// Leaf clusters of a tree (thesis §2.4); ranges: TreeKeys.h. The defaults make 16 clusters of 3 quads on
/// every branch.
struct LeafParameters {
    int clustersPerBranch = 16; ///< 0 for a bare tree.
    int clusters = 0;  ///< On the whole tree, evenly spaced along its branches; 0: clustersPerBranch applies.
    float bare = 0.0f; ///< With `clusters`: leafless share of a branch at firstLevel, from its base; falls to
                       ///< 0 at the outermost level.
    float sideShoots = 0.0f; ///< Of grown trees: length of fine shoots with leaves (SideShoots.h), metres.
    float thinWood = 1.0f;   ///< With `clusters`: share of the wood's length, thinnest first, with leaves.
    int firstLevel = 1;      ///< Lowest branch level that bears leaves (the trunk is 0).
    float length = 0.5f;     ///< Cluster length along its petiole at the outermost level, metres.
    float width = 0.45f;     ///< Cluster width, metres.
    float innerSize = 0.5f;  ///< Size at `firstLevel` over size at the outermost level.
    float droop = 0.3f;      ///< 0: clusters stand off the branch; 1: they hang down; -1: they point up.
    /// With `clusters`: mean angle of leaf faces from the horizontal, radians; each cluster is a flat spray
    /// with its own angle. 0: clusters are fans with faces in all directions.
    float inclination = 0.0f;
    /// With `clusters`: each cluster is a segment of a frond (the branch), with two rows of leaflets at its
    /// sides and one that hangs. `length` is along the branch, `width` that of a row.
    bool frond = false;
    /// With `clusters` and `inclination`: each cluster is drawn as a twig with two rows of hanging shoots,
    /// longer than wide, and one row on top. Does not affect the measured crown width.
    bool hanging = false;
    float area = 0.0f;      ///< Area of all quads over the trunk's cross-section at breast height;
                            ///< `length` and `width` then give proportions only. 0: they are absolute.
    std::uint32_t seed = 1; ///< Determines the leaves.
};

/// Parameters of a tree's shape. Of the sources of its wood, the last one that is set applies.
struct TreeParameters {
    RecursiveTreeParameters wood;           ///< The recursive generator of the thesis.
    std::optional<PalmParameters> palm;     ///< A palm.
    std::optional<GrowthParameters> growth; ///< A tree grown by light.
    /// Laser scans; variant v uses scan v modulo their number. Null or at least one.
    std::shared_ptr<const std::vector<ScannedTree>> scans;
    LeafParameters leaves; ///< Leaf clusters.
};

} // namespace osgTreeWind
