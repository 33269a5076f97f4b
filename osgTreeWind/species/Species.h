// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeParameters.h>
#include <osgTreeWind/species/Appearance.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// What tells the mass of branches; trees that were weighed (GrowthLaws.h).
enum class WoodAllometry {
    Drawn,     ///< The branches of the model.
    Conifer,   ///< A softwood's, by diameter and height.
    Broadleaf, ///< A hardwood's total by diameter less its trunk; not less than drawn.
};

/// Mechanical properties of wood and crown, SI units. Sources: docs/validation.md; ranges:
/// SpeciesFields.h.
struct WoodParameters {
    float elasticModulus = 9.0e9f; ///< Of green wood, Pa.
    // The rest is for the laws in SI units.
    float density = 900.0f;     ///< Of green wood with its bark, kg/m^3.
    float underBark = 1.0f;     ///< Diameter of the wood that bends, over that with its bark.
    float dampingRatio = 0.05f; ///< Of wood, without air.
    float leafArea = 1800.0f;   ///< Of a tree with leaves, over its trunk's cross-section at breast height.
    float leafMass = 0.2f;      ///< Fresh leaves over their area, kg/m^2.
    float woodDrag = 1.0f;      ///< Drag coefficient of a bare branch.
    float leafDrag = 0.25f;     ///< Of leaves by their area, where no crownDrag is known.
    float stillDrag = 0.9f;     ///< Of leaves by their area that move through still air.
    float crownDrag = 0.0f;     ///< C of a whole crown by its outline, C u^-n; 0: not known. >= 0.
    float streamlining = 0.0f;  ///< n: drag falls with the wind speed from 10 m/s on,
    float breezeStreamlining = 0.0f; ///< and with this power below, from 1.6 m/s on (law `modal`).
    float streamlinedTo = 25.0f;     ///< The highest speed at which it was measured, m/s.

    // How a living tree differs from clear wood on rock (GrowthLaws.h).
    float wholeStem = 1.0f;     ///< Modulus of a living stem over elasticModulus.
    float branchModulus = 1.0f; ///< Modulus of branches over that of the trunk.
    float modulusPower = 0.0f;  ///< Power of the slenderness that the modulus follows.
    float anchorage = 0.0f;     ///< Moment that overturns a tree over its stem, N m/kg; 0: rock.
    WoodAllometry branchWood = WoodAllometry::Drawn; ///< How much wood is in branches.

    // What a stem bears.
    float bendingStrength = 0.0f; ///< Modulus of rupture of green clear wood, Pa; 0: not known.
    float knotFactor = 1.0f;      ///< What knots leave of it.
};

/// Height from the diameter of the trunk at breast height: scale * diameter^power, metres. A scale of 0: not
/// known. The spreads of this and of the crown are standard deviations of logarithms.
struct HeightAllometry {
    float scale = 0.0f;      ///< In a forest.
    float power = 0.6f;      ///< In a forest.
    float spread = 0.0f;     ///< In a forest.
    float openScale = 0.0f;  ///< With room on all sides.
    float openPower = 0.6f;  ///< With room on all sides.
    float openSpread = 0.0f; ///< With room on all sides.
    std::string source;      ///< Of its numbers, for people.
};

/// Width of a crown from the diameter of its trunk at breast height: base + perDiameter * diameter, metres;
/// and its depth from the height of the tree. All 0: not known.
struct CrownAllometry {
    float base = 0.0f;            ///< In a forest, metres.
    float perDiameter = 0.0f;     ///< In a forest.
    float openBase = 0.0f;        ///< With room on all sides, metres.
    float openPerDiameter = 0.0f; ///< With room on all sides.
    float spread = 0.0f;          ///< In a forest.
    float openSpread = 0.0f;      ///< With room on all sides.
    /// From the lowest green bough to the top, in a forest; with room on all sides it is as the species
    /// grows.
    float depth = 0.0f;
    float depthPerHeight = 0.0f; ///< What is added to it for each metre of height.
};

/// How branches answer the wind under the thesis' laws (§3.1, appendix B). Angles in radians.
struct BranchParameters {
    float maxAngle = 0.5f;       ///< Largest angle about either axis.
    float partialSteps = 24.0f;  ///< `NUMB`: a new angle is reached in this many partial steps.
    float levelFactor = 0.0f;    ///< `factor`: added to the load per branch level (§3.1.2), m/s.
    float noiseFrequency = 0.7f; ///< Of the load noise, Hz.
};

/// How leaf clusters flutter (§3.2, appendix D) and turn out of the wind. Angles in radians.
struct LeafMotion {
    float maxAngleX = 0.35f;     ///< `maxMotionAngleX`, about the leaf's thesis Z axis.
    float maxAngleZ = 0.35f;     ///< `maxMotionAngleZ`, about the leaf's X axis.
    float maxRotation = 0.6f;    ///< `maxRotationAngle`, about the petiole.
    float partialSteps = 6.0f;   ///< `NUM`.
    float factor = 1.0f;         ///< `fact`.
    float linkedFactor = 0.7f;   ///< `linkedFactor`: rotation that goes with the X motion.
    float noiseFrequency = 1.3f; ///< Hz.
    float size = 0.06f;          ///< Of a single leaf or leaflet across, m; law `modal`.
    float tremble = 1.0f;        ///< Factor on how far single leaves move in a breeze; law `modal`.
    float maxDownwind = 0.8f; ///< Turn downwind of a petiole across the wind, in the strongest; law `modal`.
    float shootSway = 1.0f;   ///< Factor on how far the thin ends of boughs sway by themselves; law `modal`.
};

/// The most distinct models of one species.
constexpr int mostShapes = 64;

/// A kind of tree: how it grows, moves and looks.
struct Species {
    std::string name;                 ///< Common, as files have it.
    std::vector<std::string> aliases; ///< Other names, common and scientific ones.
    std::string source;               ///< Of its numbers, for people.
    TreeParameters tree;              ///< How it grows.
    int shapes = 4;                   ///< Distinct models shared by all trees of the species.
    HeightAllometry height;           ///< From its diameter.
    CrownAllometry crown;             ///< From its diameter and height.
    WoodParameters wood;              ///< What it is made of.
    BranchParameters branch;          ///< How the laws of the thesis turn it.
    LeafMotion leaf;                  ///< How its leaves flutter.
    Appearance appearance;            ///< How it looks.
};

} // namespace osgTreeWind
