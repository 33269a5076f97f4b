// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowthKeys.h>

namespace osgTreeWind {

template <>
const Keys& keysOf<GrowthParameters>() {
    using G = GrowthParameters;
    using H = TreeHabit;
    static const Keys keys = {
        {"height", at<&G::size, &GrowthGoal::height>, within(1, 100), "Height of the tree", "m"},
        {"trunk_diameter", at<&G::size, &GrowthGoal::trunkDiameter>, within(0.01, 5), "Stem diameter (DBH)",
         "m"},
        {"crown_width", at<&G::size, &GrowthGoal::crownWidth>, within(0.2, 60), "Mean crown width", "m"},
        {"model", at<&G::habit, &H::model>, {}, "Architectural model (Hallé and Oldeman); informational"},
        {"annual_shoot", at<&G::habit, &H::annualShoot>, within(0.02, 2), "Yearly length of a vigorous shoot",
         "m"},
        {"internode", at<&G::habit, &H::internode>, within(0.08, 1), "Distance between side buds", "m"},
        {"half_vigour", at<&G::habit, &H::halfVigour>, within(1, 1000),
         "Age at which the growth of an axis has halved", "years"},
        {"rounding", at<&G::habit, &H::rounding>, within(0, 1),
         "Slowing of shoots at the crown's outline: 0 makes a spire, 1 a dome"},
        {"deepest", at<&G::habit, &H::deepest>, within(1, 8), "Highest branching order"},
        {"buds_per_node", at<&G::habit, &H::budsPerNode>, within(1, 4),
         "Side buds per node: 1 is alternate, 2 opposite"},
        {"divergence", at<&G::habit, &H::divergence>, within(0, 180), "Rotation about the axis between nodes",
         "degrees"},
        {"branch_angle", at<&G::habit, &H::branchAngle>, within(5, 130), "Angle of side shoots from the axis",
         "degrees"},
        {"flat", at<&G::habit, &H::flat>, within(0, 1),
         "Arrangement of side shoots: 0 all around, 1 left and right"},
        {"whorl", at<&G::habit, &H::whorl>, within(0, 8), "Side shoots per yearly whorl of the trunk"},
        {"between_whorls", at<&G::habit, &H::betweenWhorls>, within(0, 1),
         "Vigour of side buds between whorls, relative to whorls"},
        {"acrotony", at<&G::habit, &H::acrotony>, within(0, 1),
         "Preference for side buds near a shoot's end, in species without whorls"},
        {"bud_life", at<&G::habit, &H::budLife>, within(0, 60), "Time until a resting side bud dies",
         "years"},
        {"apical_control", at<&G::habit, &H::apicalControl>, within(0.35, 0.8),
         "Share of resources that stays on the axis"},
        {"apical_control_old", at<&G::habit, &H::apicalControlOld>, within(0.35, 0.8),
         "`apical_control` of the trunk at full height"},
        {"trunk_top", at<&G::habit, &H::trunkTop>, within(0.1, 1),
         "Share of the height at which limbs replace the trunk; 1: never"},
        {"limbs", at<&G::habit, &H::limbs>, within(2, 6), "Number of limbs"},
        {"forking", at<&G::habit, &H::forking>, within(0, 1),
         "Yearly chance that side buds replace an axis's end"},
        {"rise", at<&G::habit, &H::rise>, within(-6, 6), "Upward pull on shoots; downward if negative",
         "1/m"},
        {"levelling", at<&G::habit, &H::levelling>, within(0, 6), "Pull towards the horizontal", "1/m"},
        {"light_seeking", at<&G::habit, &H::lightSeeking>, within(0, 6), "Pull towards the light", "1/m"},
        {"wander", at<&G::habit, &H::wander>, within(0, 1),
         "Random bending, in radians per metre; also varies the vigour of boughs and the lean of trunks"},
        {"zigzag", at<&G::habit, &H::zigzag>, within(0, 0.6),
         "Alternating bend at nodes, except in the trunk, in radians"},
        {"sink", at<&G::habit, &H::sink>, within(-60, 120),
         "Angle by which an axis sinks at its base over a long life", "degrees"},
        {"hang", at<&G::habit, &H::hang>, within(-120, 240),
         "Bending of an axis under its own weight; in the trunk, nodding of the tip", "degrees/m"},
        {"leaf_area", at<&G::habit, &H::leafArea>, within(0.02, 2),
         "One-sided leaf area per metre of young shoot", "m²/m"},
        {"leaf_years", at<&G::habit, &H::leafYears>, within(1, 12), "Time for which a shoot bears leaves",
         "years"},
        {"light_need", at<&G::habit, &H::lightNeed>, within(0.01, 0.6),
         "Share of full light that a branch needs"},
        {"dead_years", at<&G::habit, &H::deadYears>, within(0, 40), "Time until a dead bough falls", "years"},
        {"breakage", at<&G::habit, &H::breakage>, within(0, 0.1), "Yearly chance that a bough breaks"},
        {"clean_stem", at<&G::habit, &H::cleanStem>, within(0, 0.8),
         "Share of the height without boughs, if open-grown"},
        {"twig_radius", at<&G::habit, &H::twigRadius>, within(0.0003, 0.02), "Radius of the thinnest shoots",
         "m"},
        {"flare", at<&G::flare>, within(0, 3), "Relative widening of the trunk radius at the ground"},
        {"seed", at<&G::seed>, {}, "Random seed"},
    };
    return keys;
}

} // namespace osgTreeWind
