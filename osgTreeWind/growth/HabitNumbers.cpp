// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/HabitNumbers.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace osgTreeWind {

const std::vector<HabitNumber>& habitNumbers() {
    using H = TreeHabit;
    static const std::vector<HabitNumber> numbers = {
        {"annual_shoot", &H::annualShoot, 0.02f, 2, "m"},
        {"internode", &H::internode, 0.08f, 1, "m"},
        {"half_vigour", &H::halfVigour, 1, 1000, "years"},
        {"rounding", &H::rounding, 0, 1, ""},
        {"deepest", &H::deepest, 1, 8, "", true},
        {"buds_per_node", &H::budsPerNode, 1, 4, "", true},
        {"divergence", &H::divergence, 0, 180, "degrees"},
        {"branch_angle", &H::branchAngle, 5, 130, "degrees"},
        {"flat", &H::flat, 0, 1, ""},
        {"whorl", &H::whorl, 0, 8, ""},
        {"between_whorls", &H::betweenWhorls, 0, 1, ""},
        {"acrotony", &H::acrotony, 0, 1, ""},
        {"bud_life", &H::budLife, 0, 60, "years"},
        {"apical_control", &H::apicalControl, 0.35f, 0.8f, ""},
        {"apical_control_old", &H::apicalControlOld, 0.35f, 0.8f, ""},
        {"trunk_top", &H::trunkTop, 0.1f, 1, ""},
        {"limbs", &H::limbs, 2, 6, "", true},
        {"forking", &H::forking, 0, 1, ""},
        {"rise", &H::rise, -6, 6, "1/m"},
        {"levelling", &H::levelling, 0, 6, "1/m"},
        {"light_seeking", &H::lightSeeking, 0, 6, "1/m"},
        {"wander", &H::wander, 0, 1, ""},
        {"zigzag", &H::zigzag, 0, 0.6f, ""},
        {"sink", &H::sink, -60, 120, "degrees"},
        {"hang", &H::hang, -120, 240, "degrees/m"},
        {"leaf_area", &H::leafArea, 0.02f, 2, "m²/m"},
        {"leaf_years", &H::leafYears, 1, 12, "years", true},
        {"light_need", &H::lightNeed, 0.01f, 0.6f, ""},
        {"dead_years", &H::deadYears, 0, 40, "years", true},
        {"breakage", &H::breakage, 0, 0.1f, ""},
        {"clean_stem", &H::cleanStem, 0, 0.8f, ""},
        {"twig_radius", &H::twigRadius, 0.0003f, 0.02f, "m"},
    };
    return numbers;
}

TreeHabit clampedHabit(TreeHabit habit) {
    static const TreeHabit usual;
    for (const HabitNumber& number : habitNumbers()) {
        const float unit = std::strncmp(number.unit, "degrees", 7) == 0 ? 0.017453293f : 1.0f;
        const auto bring = [&](float& value, float otherwise) {
            value =
                std::isnan(value) ? otherwise : std::clamp(value, number.least * unit, number.most * unit);
            if (number.whole)
                value = std::floor(value + 0.5f);
        };
        if (const auto* one = std::get_if<float TreeHabit::*>(&number.member)) {
            bring(habit.**one, usual.**one);
        } else {
            const auto member = std::get<ByOrder TreeHabit::*>(number.member);
            for (std::size_t i = 0; i < 4; ++i)
                bring((habit.*member)[i], (usual.*member)[i]);
        }
    }
    return habit;
}

float gridCell(const TreeHabit& habit) {
    return std::clamp(1.8f * habit.internode[0], 0.3f, 0.6f);
}

} // namespace osgTreeWind
