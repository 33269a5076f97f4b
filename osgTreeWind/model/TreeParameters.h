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

/// How leaves sit on a tree (thesis §2.4); ranges: TreeFields.h. The default makes 16 clusters of 3 quads on
/// every branch.
struct LeafParameters {
    int clustersPerBranch = 16; ///< 0 for a bare tree.
    int clusters = 0;  ///< Of the whole tree, spread evenly along its branches; 0: clustersPerBranch holds.
    float bare = 0.0f; ///< Of `clusters`: share of a branch at firstLevel without any, from its base; on
                       ///< further levels less, on the outermost 0.
    float thinWood = 1.0f; ///< Of `clusters`: share of the length of all wood, the thinnest, that bears some.
    int firstLevel = 1;    ///< Lowest branch level that bears leaves (the trunk is 0).
    float length = 0.5f;   ///< Cluster length along its petiole at the outermost level, metres.
    float width = 0.45f;   ///< Cluster width, metres.
    float innerSize = 0.5f; ///< Size at `firstLevel` over size at the outermost level.
    float droop = 0.3f;     ///< 0: clusters stand off the branch; 1: they hang down; -1: they point up.
    /// Of `clusters`: mean angle of leaf faces from the horizontal, radians; each cluster is a flat
    /// spray with its own. 0: clusters are fans, with faces to all sides.
    float inclination = 0.0f;
    /// Of `clusters`: each is a segment of a frond, which is the branch, with rows of leaflets on both sides
    /// and one that hangs. `length` is along the branch, `width` that of a row.
    bool frond = false;
    /// Of `clusters` with an inclination: each is drawn as a twig with two rows of shoots that hang, more
    /// than twice as long as wide, and one upon it. How wide a crown is does not follow from it.
    bool hanging = false;
    float area = 0.0f;      ///< Of all quads over the trunk's cross-section at breast height; 0: length
                            ///< and width hold as they are, else they tell the proportions.
    std::uint32_t seed = 1; ///< One seed gives the same leaves.
};

/// Everything that shapes a tree.
struct TreeParameters {
    RecursiveTreeParameters wood;           ///< Of a tree grown by the rule of the thesis.
    std::optional<PalmParameters> palm;     ///< In place of `wood`.
    std::optional<GrowthParameters> growth; ///< In place of both: it grows by light.
    /// In place of all: variant v takes scan v modulo their number. Null or at least one.
    std::shared_ptr<const std::vector<ScannedTree>> scans;
    LeafParameters leaves; ///< That hang on its wood.
};

} // namespace osgTreeWind
