// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

namespace osgTreeWind {

/// One number for each branching order: the trunk, its boughs, their branches, and all twigs beyond.
using ByOrder = std::array<float, 4>;

/// Growth habit of a species: quantities that a botanist measures on its shoots. Lengths are in metres,
/// angles in radians, times in years. GrowthKeys.h has the ranges.
struct TreeHabit {
    std::string model = "Rauh"; ///< Architectural model (Hallé, Oldeman, Tomlinson 1978); informational.

    // Shoots
    ByOrder annualShoot{0.4f, 0.3f, 0.2f, 0.15f}; ///< Yearly length of a vigorous shoot.
    ByOrder internode{0.25f, 0.2f, 0.18f, 0.15f}; ///< Length of a metamer, between side buds.
    ByOrder halfVigour{200, 30, 20, 12};          ///< Age of an axis at which it grows half as fast.
    float rounding = 0.5f; ///< Slowing of shoots at the crown's outline: 0 makes a spire, 1 a dome.
    int deepest = 6;       ///< Highest branching order.

    // Side shoots
    int budsPerNode = 1;                         ///< 1 alternate, 2 opposite, from 3 in a circle.
    float divergence = 2.4f;                     ///< Rotation from one node to the next.
    ByOrder branchAngle{1.0f, 0.9f, 0.8f, 0.8f}; ///< Angle between a side shoot and its axis.
    ByOrder flat{0, 0, 0, 0};                    ///< Side shoots of an axis: 0 all around, 1 left and right.
    float whorl = 0;         ///< Side shoots per yearly whorl of the trunk; 0 without whorls.
    float betweenWhorls = 0; ///< Vigour of side buds between whorls.
    float acrotony = 0.5f;   ///< 0 all side buds of a shoot grow alike, 1 only those near its tip.
    float budLife = 10;      ///< Time until a resting side bud dies.

    // Dominance
    ByOrder apicalControl{0.54f, 0.52f, 0.5f, 0.5f}; ///< Share of growth that stays on the axis.
    float apicalControlOld = 0.5f;                   ///< `apicalControl` of the trunk at full height.
    float trunkTop = 1.0f; ///< Share of the height where limbs replace the trunk; 1 is never.
    int limbs = 3;         ///< Number of limbs.
    ByOrder forking{0, 0.03f, 0.05f, 0.05f}; ///< Yearly chance that the tip of an axis dies and is replaced
                                             ///< by a side bud, or by both of a pair.

    // Directions
    ByOrder rise{1.0f, 0.15f, 0.1f, 0.05f};       ///< Upward pull on shoots, downward if negative; 1/m.
    ByOrder levelling{0, 0, 0, 0};                ///< Pull towards the horizontal; 1/m.
    ByOrder lightSeeking{0.3f, 0.5f, 0.6f, 0.6f}; ///< Pull towards the light; 1/m.
    ByOrder wander{0.08f, 0.15f, 0.2f, 0.2f};     ///< Random bends, radians per metre; also raises the
                                                  ///< lean of stems and the variety of boughs.
    float zigzag = 0;                             ///< Alternating bend at the nodes beyond the trunk.
    ByOrder sink{0, 0, 0, 0};                     ///< Downward rotation at an axis's base in a long life.
    ByOrder hang{0, 0, 0, 0};                     ///< Bending under its own weight, radians per metre;
                                                  ///< for the trunk, nodding of its tip.

    // Leaves and losses
    float leafArea = 0.25f;    ///< One-sided leaf area per metre of shoot, m²/m.
    int leafYears = 2;         ///< Time for which a shoot bears leaves; its tip always does.
    float lightNeed = 0.12f;   ///< Share of full light below which a branch dies.
    int deadYears = 3;         ///< Time until a dead bough falls.
    float breakage = 0.002f;   ///< Yearly chance that storm or snow breaks a bough.
    float cleanStem = 0.1f;    ///< Share of the height without boughs, in the open.
    float twigRadius = 0.002f; ///< Radius of the thinnest shoots.
};

} // namespace osgTreeWind
