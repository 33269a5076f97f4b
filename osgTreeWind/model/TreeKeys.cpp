// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeKeys.h>

#include <osgTreeWind/model/RecursiveTree.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<RecursiveTreeParameters>() {
    using P = RecursiveTreeParameters;
    static const Keys keys = {
        {"levels", at<&P::levels>, within(0, 8), "Levels of branches above the trunk"},
        {"children_per_branch", at<&P::childrenPerBranch>, within(1, 8),
         "Branches at the end of each branch"},
        {"trunk_units", at<&P::trunkUnits>, within(1, 16), "Units in the trunk"},
        {"bare_units", at<&P::bareUnits>, within(0, 15),
         "Number of lowest trunk units without branches, at most `trunk_units` - 1"},
        {"rings_per_branch", at<&P::ringsPerBranch>, within(2, 64), "Rings of vertices per branch"},
        {"length", at<&P::length>, within(0.01, 100), "Length of a trunk unit", "m"},
        {"length_ratio", at<&P::lengthRatio>, within(0.05, 1.5), "Other branch length / parent length"},
        {"bough_length", at<&P::boughLength>, within(0.02, 1.5), "First-level branch length / trunk length"},
        {"crown_taper", at<&P::crownTaper>, within(0.02, 1.5),
         "Ratio of the topmost to the lowest first-level branch length"},
        {"leader", at<&P::leader>, within(0, 1),
         "Straightness of one branch per fork: 0 leans like the others, 1 goes straight on"},
        {"inclination", at<&P::inclination>, within(0, 124),
         "Angle of first-level branches from the vertical", "degrees"},
        {"inclination_growth", at<&P::inclinationGrowth>, within(0.05, 3),
         "Factor on the inclination from level to level"},
        {"follow", at<&P::follow>, within(0, 1),
         "Reference direction of branch angles: 0 is the vertical, 1 the parent's axis"},
        {"twist", at<&P::twist>, within(-360, 360), "Rotation of branch azimuths per level", "degrees"},
        {"jitter", at<&P::jitter>, within(0, 1), "Random variation of lengths and directions"},
        {"crook", at<&P::crook>, within(0, 0.3), "Largest sideways offset / branch length"},
        {"radius", at<&P::radius>, within(0.001, 10),
         "Trunk radius at the ground; at most half the trunk's length", "m"},
        {"taper", at<&P::taper>, within(0.01, 1), "Ratio of tip to base radius, of trunk and branches"},
        {"radius_ratio", at<&P::radiusRatio>, within(0.01, 1), "Branch base radius / parent tip radius"},
        {"seed", at<&P::seed>, {}, "Random seed"},
    };
    return keys;
}

template <>
const Keys& keysOf<PalmParameters>() {
    using P = PalmParameters;
    static const Keys keys = {
        {"height", at<&P::height>, within(0.5, 60), "Height of the highest frond", "m"},
        {"trunk_diameter", at<&P::trunkDiameter>, within(0.01, 5),
         "Stem diameter (DBH); at most half the stem height", "m"},
        {"crown_width", at<&P::crownWidth>, within(0.1, 30), "Crown width; at most four times the height",
         "m"},
        {"crown_base", at<&P::crownBase>, within(0.05, 1), "Relative height of the oldest frond's foot"},
        {"trunk", at<&P::trunk>, within(0.05, 1), "Relative height of the stem; at least `crown_base`"},
        {"trunk_taper", at<&P::trunkTaper>, within(0.05, 1), "Ratio of top to ground radius of the stem"},
        {"trunk_crook", at<&P::trunkCrook>, within(0, 1), "Curvature of the stem"},
        {"flare", at<&P::flare>, within(0, 3), "Relative widening of the stem radius at the ground"},
        {"fronds", at<&P::fronds>, within(0, 200), "Number of fronds"},
        {"inclination", at<&P::inclination>, within(0, 180), "Angle of the oldest frond from the stem",
         "degrees"},
        {"inclination_end", at<&P::inclinationEnd>, within(0, 180),
         "Angle of the youngest frond from the stem", "degrees"},
        {"droop", at<&P::droop>, within(0, 180), "Downward bend along a frond", "degrees"},
        {"frond_radius", at<&P::frondRadius>, within(0.001, 0.2), "Radius of a frond's stalk at its foot",
         "m"},
        {"seed", at<&P::seed>, {}, "Random seed"},
    };
    return keys;
}

template <>
const Keys& keysOf<LeafParameters>() {
    using P = LeafParameters;
    static const Keys keys = {
        {"clusters_per_branch", at<&P::clustersPerBranch>, within(0, 64),
         "Clusters on each branch; 0 makes a bare tree"},
        {"clusters", at<&P::clusters>, within(0, 100000),
         "Clusters on the whole tree; 0 uses `clusters_per_branch`"},
        {"bare", at<&P::bare>, within(0, 0.95),
         "Leafless share of a branch, from its base, at `first_level`; it falls to 0 at the outermost level"},
        {"first_level", at<&P::firstLevel>, within(0, 9), "Lowest branch level with leaves; the trunk is 0"},
        {"length", at<&P::length>, within(0.001, 10), "Length of a cluster along its petiole", "m"},
        {"width", at<&P::width>, within(0.001, 10), "Width of a cluster", "m"},
        {"inner_size", at<&P::innerSize>, within(0.01, 1),
         "Ratio of the cluster size at `first_level` to that at the outermost level; needs "
         "`clusters_per_branch`"},
        {"droop", at<&P::droop>, within(-1, 1),
         "Direction of clusters: 1 down, 0 away from the branch, -1 up"},
        {"inclination", at<&P::inclination>, within(0, 80),
         "Mean angle of leaf faces from the horizontal; 0 makes fans with faces in all directions instead of "
         "flat clusters",
         "degrees"},
        {"frond", at<&P::frond>, {}, "Whether clusters are segments of fronds"},
        {"hanging",
         at<&P::hanging>,
         {},
         "Whether clusters are conifer twigs with hanging shoots; needs `inclination`"},
        {"side_shoots", at<&P::sideShoots>, within(0, 3),
         "Length of fine side shoots with leaves in the gaps of a crown grown by `[species.habit]`; 0: none",
         "m"},
        {"thin_wood", at<&P::thinWood>, within(0, 1),
         "Share of the wood's length, thinnest first, that bears leaves"},
        {"area", at<&P::area>, within(0, 1e6),
         "Total quad area / trunk cross-section at breast height; 0 keeps `length` and `width`; without it, "
         "the rule above applies"},
        {"seed", at<&P::seed>, {}, "Random seed"},
    };
    return keys;
}

std::vector<KeyConflict> conflictsOf(const RecursiveTreeParameters& tree) {
    std::vector<KeyConflict> conflicts;
    if (tree.radius > 0.5f * tree.length * static_cast<float>(tree.trunkUnits))
        conflicts.push_back({"radius", "", "expected at most half the trunk, length * trunk_units"});
    if (clamped(tree).levels != tree.levels)
        conflicts.push_back({"levels", "",
                             "with children_per_branch and rings_per_branch they make more than " +
                                 std::to_string(maxSkeletonPoints) + " skeleton points"});
    return conflicts;
}

std::vector<KeyConflict> conflictsOf(const PalmParameters& palm) {
    std::vector<KeyConflict> conflicts;
    if (palm.trunk < palm.crownBase)
        conflicts.push_back({"trunk", "crown_base", "expected at least crown_base"});
    if (palm.trunkDiameter > 0.5f * palm.height * palm.trunk)
        conflicts.push_back({"trunk_diameter", "", "expected at most half the height of the stem"});
    return conflicts;
}

} // namespace osgTreeWind
