// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/GrowthFields.h>

namespace osgTreeWind {

template <>
const Fields& fieldsOf<GrowthParameters>() {
    using G = GrowthParameters;
    using H = TreeHabit;
    static const Fields fields = {
        {"height", at<&G::size, &GrowthGoal::height>, within(1, 100), "of the tree", "m"},
        {"trunk_diameter", at<&G::size, &GrowthGoal::trunkDiameter>, within(0.01, 5), "at breast height",
         "m"},
        {"crown_width", at<&G::size, &GrowthGoal::crownWidth>, within(0.2, 60), "mean of all directions",
         "m"},
        {"model", at<&G::habit, &H::model>, {}, "architectural model after Hallé and Oldeman; a note"},
        {"annual_shoot", at<&G::habit, &H::annualShoot>, within(0.02, 2),
         "length of a vigorous shoot after a year", "m"},
        {"internode", at<&G::habit, &H::internode>, within(0.08, 1), "from one side bud to the next", "m"},
        {"half_vigour", at<&G::habit, &H::halfVigour>, within(1, 1000),
         "age of an axis at which it grows half as fast", "years"},
        {"rounding", at<&G::habit, &H::rounding>, within(0, 1),
         "how much shoots slow down as they come to the outside of a dome: 0 a spire, 1 a dome"},
        {"deepest", at<&G::habit, &H::deepest>, within(1, 8), "highest order of branching"},
        {"buds_per_node", at<&G::habit, &H::budsPerNode>, within(1, 4), "1: alternate, 2: opposite"},
        {"divergence", at<&G::habit, &H::divergence>, within(0, 180), "turn from one node to the next",
         "degrees"},
        {"branch_angle", at<&G::habit, &H::branchAngle>, within(5, 130),
         "between a side shoot and the axis that bears it", "degrees"},
        {"flat", at<&G::habit, &H::flat>, within(0, 1), "side shoots: 0 on all sides, 1 left and right"},
        {"whorl", at<&G::habit, &H::whorl>, within(0, 8),
         "side shoots at the end of each year's shoot of the trunk; 0: none"},
        {"between_whorls", at<&G::habit, &H::betweenWhorls>, within(0, 1),
         "vigour of the side buds below the end of a shoot, where there are whorls"},
        {"acrotony", at<&G::habit, &H::acrotony>, within(0, 1),
         "0: all side buds of a shoot are alike; 1: only those near its end grow"},
        {"bud_life", at<&G::habit, &H::budLife>, within(0, 60),
         "after so long a side bud that cannot grow dies", "years"},
        {"apical_control", at<&G::habit, &H::apicalControl>, within(0.35, 0.8),
         "share that goes on along the axis"},
        {"apical_control_old", at<&G::habit, &H::apicalControlOld>, within(0.35, 0.8),
         "that of the trunk when the tree has its height"},
        {"trunk_top", at<&G::habit, &H::trunkTop>, within(0.1, 1),
         "share of the height at which the trunk divides into limbs; 1: never"},
        {"limbs", at<&G::habit, &H::limbs>, within(2, 6), "number of these limbs"},
        {"forking", at<&G::habit, &H::forking>, within(0, 1),
         "chance, each year, that the end of an axis dies and the next side buds go on"},
        {"rise", at<&G::habit, &H::rise>, within(-6, 6), "pull upwards on growing shoots, below 0 downwards",
         "1/m"},
        {"levelling", at<&G::habit, &H::levelling>, within(0, 6), "pull towards the horizontal", "1/m"},
        {"light_seeking", at<&G::habit, &H::lightSeeking>, within(0, 6), "pull towards the light", "1/m"},
        {"wander", at<&G::habit, &H::wander>, within(0, 1), "random bends, radians in a metre"},
        {"zigzag", at<&G::habit, &H::zigzag>, within(0, 0.6),
         "bend at each node, to and fro, of boughs and beyond, radians"},
        {"sink", at<&G::habit, &H::sink>, within(-60, 120),
         "angle by which an axis sinks at its foot in a long life", "degrees"},
        {"hang", at<&G::habit, &H::hang>, within(-120, 240),
         "bend by its own weight; of the trunk: its youngest end nods", "degrees/m"},
        {"leaf_area", at<&G::habit, &H::leafArea>, within(0.02, 2),
         "leaves on a metre of shoot while it grows, one side", "m²/m"},
        {"leaf_years", at<&G::habit, &H::leafYears>, within(1, 12), "for so long a shoot bears leaves",
         "years"},
        {"light_need", at<&G::habit, &H::lightNeed>, within(0.01, 0.6),
         "a branch dies whose leaves get less than this share of full light"},
        {"dead_years", at<&G::habit, &H::deadYears>, within(0, 40), "after so long a dead bough falls",
         "years"},
        {"breakage", at<&G::habit, &H::breakage>, within(0, 0.1),
         "chance, each year, that storm or snow breaks a bough"},
        {"clean_stem", at<&G::habit, &H::cleanStem>, within(0, 0.8),
         "share of the height below which a tree in the open has lost its boughs"},
        {"twig_radius", at<&G::habit, &H::twigRadius>, within(0.0003, 0.02), "of the thinnest shoots", "m"},
        {"flare", at<&G::flare>, within(0, 3),
         "how much wider the bark of the trunk is at the ground, over its radius there"},
        {"seed", at<&G::seed>, {}, "of its random parts"},
    };
    return fields;
}

} // namespace osgTreeWind
