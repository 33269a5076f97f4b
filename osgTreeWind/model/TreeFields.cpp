// SPDX-License-Identifier: MIT
#include <osgTreeWind/model/TreeFields.h>

#include <osgTreeWind/model/RecursiveTree.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<RecursiveTreeParameters>() {
    using P = RecursiveTreeParameters;
    static const Fields fields = {
        {"levels", at<&P::levels>, within(0, 8), "levels of branches above the trunk"},
        {"children_per_branch", at<&P::childrenPerBranch>, within(1, 8),
         "branches at the end of each branch"},
        {"trunk_units", at<&P::trunkUnits>, within(1, 16), "pieces the trunk is made of"},
        {"bare_units", at<&P::bareUnits>, within(0, 15),
         "lowest trunk units that end without branches; fewer bare than `trunk_units` - 1 make whorls up the "
         "trunk, as conifers have"},
        {"rings_per_branch", at<&P::ringsPerBranch>, within(2, 64), "rings of vertices along each branch"},
        {"length", at<&P::length>, within(0.01, 100), "length of one trunk unit", "m"},
        {"length_ratio", at<&P::lengthRatio>, within(0.05, 1.5),
         "length of any other branch over its parent's"},
        {"bough_length", at<&P::boughLength>, within(0.02, 1.5),
         "length of a first branch over the whole trunk's"},
        {"crown_taper", at<&P::crownTaper>, within(0.02, 1.5),
         "length of the topmost first branches over the lowest"},
        {"leader", at<&P::leader>, within(0, 1), "0: all children lean alike; 1: one goes straight on"},
        {"inclination", at<&P::inclination>, within(0, 124), "of a branch from the vertical", "degrees"},
        {"inclination_growth", at<&P::inclinationGrowth>, within(0.05, 3),
         "factor on the inclination from level to level"},
        {"follow", at<&P::follow>, within(0, 1), "0: angles from the vertical; 1: from the parent's axis"},
        {"twist", at<&P::twist>, within(-360, 360), "by which each level is turned against the one below",
         "degrees"},
        {"jitter", at<&P::jitter>, within(0, 1), "random part of lengths and directions"},
        {"crook", at<&P::crook>, within(0, 0.3), "largest sideways offset over branch length"},
        {"radius", at<&P::radius>, within(0.001, 10), "of the trunk at the ground; at most half its length",
         "m"},
        {"taper", at<&P::taper>, within(0.01, 1),
         "tip radius over base radius of the trunk, and of a branch; linear between"},
        {"radius_ratio", at<&P::radiusRatio>, within(0.01, 1),
         "base radius of a branch over its parent's tip radius"},
        {"seed", at<&P::seed>, {}, "of its random parts"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<PalmParameters>() {
    using P = PalmParameters;
    static const Fields fields = {
        {"height", at<&P::height>, within(0.5, 60), "of its highest frond", "m"},
        {"trunk_diameter", at<&P::trunkDiameter>, within(0.01, 5), "of its stem at breast height", "m"},
        {"crown_width", at<&P::crownWidth>, within(0.1, 30), "from end to end of fronds", "m"},
        {"crown_base", at<&P::crownBase>, within(0.05, 1),
         "height of the oldest frond's foot over that of the palm"},
        {"trunk", at<&P::trunk>, within(0.05, 1),
         "height of the stem over that of the palm, at least `crown_base`"},
        {"trunk_taper", at<&P::trunkTaper>, within(0.05, 1),
         "radius at the top of the stem over that at the ground"},
        {"trunk_crook", at<&P::trunkCrook>, within(0, 1), "how far the stem winds"},
        {"flare", at<&P::flare>, within(0, 3),
         "how much wider the stem is drawn at the ground, over its radius"},
        {"fronds", at<&P::fronds>, within(0, 200), "how many it has"},
        {"inclination", at<&P::inclination>, within(0, 180), "of the oldest frond from the stem", "degrees"},
        {"inclination_end", at<&P::inclinationEnd>, within(0, 180), "of the youngest frond", "degrees"},
        {"droop", at<&P::droop>, within(0, 180), "by which a frond bends down along its length", "degrees"},
        {"frond_radius", at<&P::frondRadius>, within(0.001, 0.2), "of a frond's stalk at its foot", "m"},
        {"seed", at<&P::seed>, {}, "of its random parts"},
    };
    return fields;
}

template <>
const Fields& fieldsOf<LeafParameters>() {
    using P = LeafParameters;
    static const Fields fields = {
        {"clusters_per_branch", at<&P::clustersPerBranch>, within(0, 64), "0 for a bare tree"},
        {"clusters", at<&P::clusters>, within(0, 100000),
         "of the whole tree, spread evenly along its branches; 0: `clusters_per_branch` holds; 3000 with "
         "`[species.habit]`, 240 with `[species.palm]`"},
        {"bare", at<&P::bare>, within(0, 0.95),
         "with `clusters`: share of a branch at `first_level` without any, from its base; less on further "
         "levels"},
        {"first_level", at<&P::firstLevel>, within(0, 9), "lowest level that bears leaves; the trunk is 0"},
        {"length", at<&P::length>, within(0.001, 10), "of a cluster, along its petiole", "m"},
        {"width", at<&P::width>, within(0.001, 10), "", "m"},
        {"inner_size", at<&P::innerSize>, within(0.01, 1),
         "size at `first_level` over size at the outermost level"},
        {"droop", at<&P::droop>, within(-1, 1), "1: clusters hang; 0: stand off the branch; -1: point up"},
        {"inclination", at<&P::inclination>, within(0, 80),
         "with `clusters`: mean angle of leaf faces from the horizontal; clusters then are flat sprays. 0: "
         "fans with faces to all sides",
         "degrees"},
        {"frond",
         at<&P::frond>,
         {},
         "with `clusters`: each is a segment of a frond, which is the branch: `length` along it, `width` of "
         "the "
         "rows of leaflets on both sides, and of one that hangs"},
        {"hanging",
         at<&P::hanging>,
         {},
         "with `clusters` and an `inclination`: each is drawn as a twig of a conifer, from which shoots hang "
         "on "
         "both sides; the tree is as wide as without"},
        {"thin_wood", at<&P::thinWood>, within(0, 1),
         "with `clusters`: share of the length of all wood, the thinnest, that bears some"},
        {"area", at<&P::area>, within(0, 1e6),
         "of all quads over the cross-section of the trunk at breast height: then `length` and `width` tell "
         "their proportions; 0: they hold as they are; without it as `wood.leaf_area` needs with "
         "`[species.habit]`, `[species.palm]` or `scan` and no size of a cluster, else 0"},
        {"seed", at<&P::seed>, {}, "of their places"},
    };
    return fields;
}

std::vector<FieldConflict> conflictsOf(const RecursiveTreeParameters& tree) {
    std::vector<FieldConflict> conflicts;
    if (tree.radius > 0.5f * tree.length * static_cast<float>(tree.trunkUnits))
        conflicts.push_back({"radius", "", "expected at most half the trunk, length * trunk_units"});
    if (clamped(tree).levels != tree.levels)
        conflicts.push_back({"levels", "",
                             "with children_per_branch and rings_per_branch they make more than " +
                                 std::to_string(maxSkeletonPoints) + " skeleton points"});
    return conflicts;
}

std::vector<FieldConflict> conflictsOf(const PalmParameters& palm) {
    std::vector<FieldConflict> conflicts;
    if (palm.trunk < palm.crownBase)
        conflicts.push_back({"trunk", "crown_base", "expected at least crown_base"});
    if (palm.trunkDiameter > 0.5f * palm.height * palm.trunk)
        conflicts.push_back({"trunk_diameter", "", "expected at most half the height of the stem"});
    return conflicts;
}

} // namespace osgTreeWind
