// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>

namespace osgTreeWind {

/// One number each for the trunk, the boughs on it, the branches on those, and all twigs beyond.
using ByOrder = std::array<float, 4>;

/// How a species grows: what a botanist would measure on its shoots. Lengths in metres, angles in radians,
/// times in years. GrowthFields.h has the range of each.
struct TreeHabit {
    std::string model = "Rauh"; ///< Architectural model after Hallé, Oldeman and Tomlinson 1978; a note.

    // Shoots
    ByOrder annualShoot{0.4f, 0.3f, 0.2f, 0.15f}; ///< A vigorous shoot's length in a year.
    ByOrder internode{0.25f, 0.2f, 0.18f, 0.15f}; ///< Length of a metamer: from one side bud to the next.
    ByOrder halfVigour{200, 30, 20, 12};          ///< Age of an axis at which it grows half as fast.
    float rounding =
        0.5f; ///< How much shoots slow down as they come to the outside of a dome: 0 a spire, 1 a dome.
    int deepest = 6; ///< Highest order of branching.

    // Side shoots
    int budsPerNode = 1;                         ///< 1: alternate, 2: opposite, 3 and more: in a circle.
    float divergence = 2.4f;                     ///< Turn from one node to the next.
    ByOrder branchAngle{1.0f, 0.9f, 0.8f, 0.8f}; ///< Between a side shoot and the axis that bears it.
    ByOrder flat{0, 0, 0, 0}; ///< Side shoots of an axis: 0 on all sides, 1 left and right.
    float whorl = 0;          ///< Side shoots at the end of each year's shoot of the trunk; 0: none.
    float betweenWhorls = 0;  ///< Vigour of side buds below the end of a shoot, where there are whorls.
    float acrotony = 0.5f;    ///< 0: side buds of a shoot are alike; 1: only those near its end grow.
    float budLife = 10;       ///< A side bud that cannot grow dies after so long.

    // Who leads
    ByOrder apicalControl{0.54f, 0.52f, 0.5f, 0.5f}; ///< Share that goes on along the axis (Borchert, Honda).
    float apicalControlOld = 0.5f;                   ///< That of the trunk when the tree has its height.
    float trunkTop = 1.0f; ///< Share of the height at which the trunk dissolves into limbs; 1: never.
    int limbs = 3;         ///< Into so many.
    ByOrder forking{0, 0.03f, 0.05f, 0.05f}; ///< Chance, each year, that the end of an axis dies: the next
                                             ///< side bud goes on, or both of a pair.

    // Directions
    ByOrder rise{1.0f, 0.15f, 0.1f, 0.05f};       ///< Pull up, below 0 down, of growing shoots; 1/m.
    ByOrder levelling{0, 0, 0, 0};                ///< Pull towards the horizontal; 1/m.
    ByOrder lightSeeking{0.3f, 0.5f, 0.6f, 0.6f}; ///< Pull towards the light; 1/m.
    ByOrder wander{0.08f, 0.15f, 0.2f, 0.2f};     ///< Random bends; radians in a metre. The more, the
                                                  ///< more stems lean and the less boughs are alike.
    float zigzag = 0;                             ///< Bend at each node, to and fro, of boughs and beyond.
    ByOrder sink{0, 0, 0, 0};                     ///< By which an axis sinks at its foot in a long life.
    ByOrder hang{0, 0, 0, 0};                     ///< By which its own weight bends it down; radians a metre.
                                                  ///< Of the trunk: its youngest end nods.

    // Leaves and losses
    float leafArea = 0.25f;    ///< One side of the leaves on a metre of shoot; m².
    int leafYears = 2;         ///< A shoot bears leaves for so long; its end always does.
    float lightNeed = 0.12f;   ///< A branch whose leaves get less than this share of full light dies.
    int deadYears = 3;         ///< A dead bough falls after so long.
    float breakage = 0.002f;   ///< Chance, each year, that storm or snow breaks a bough.
    float cleanStem = 0.1f;    ///< Share of the height below which an open-grown tree has lost its boughs.
    float twigRadius = 0.002f; ///< Of its thinnest shoots.
};

} // namespace osgTreeWind
