// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/model/TreeParameters.h>
#include <osgTreeWind/species/Appearance.h>

#include <string>
#include <vector>

namespace osgTreeWind {

/// Source of the mass of branches; see branchWoodMass().
enum class WoodAllometry {
    Drawn,     ///< Branches of the model.
    Conifer,   ///< Weighed softwoods, by diameter and height, and the stem above the trunk.
    Broadleaf, ///< Weighed hardwoods: by diameter and height, or the total by diameter minus the trunk.
};

/// Mechanical properties of wood and crown, SI units. Sources: docs/validation.md; ranges:
/// SpeciesKeys.h.
struct WoodParameters {
    float elasticModulus = 9.0e9f; ///< Elastic modulus of green wood, Pa.
    // Only the law `modal` and the effect of trees on the wind use the rest.
    float density = 900.0f;     ///< Density of green wood with bark, kg/m^3.
    float underBark = 1.0f;     ///< Diameter of the wood without bark / with bark.
    float dampingRatio = 0.05f; ///< Damping ratio of the wood, without air.
    float leafArea = 1800.0f;   ///< Leaf area / trunk cross-section at breast height.
    float leafMass = 0.2f;      ///< Mass of fresh leaves / leaf area, kg/m^2.
    float woodDrag = 1.0f;      ///< Drag coefficient of a bare branch.
    float leafDrag = 0.25f;    ///< Drag coefficient of leaves at 10 m/s, by leaf area; unused with crownDrag.
    float stillDrag = 0.9f;    ///< Drag coefficient of leaves that swing in still air, by leaf area.
    float crownDrag = 0.0f;    ///< C in the drag coefficient C u^-n of the crown's outline; 0 if unknown.
    float streamlining = 0.0f; ///< Exponent n above 10 m/s.
    float breezeStreamlining = 0.0f; ///< Exponent n from 1.6 to 10 m/s (law `modal`).
    float streamlinedTo = 25.0f;     ///< Highest measured speed, m/s; C u^-n is constant above.

    // Differences between a living tree and clear wood on rigid ground (GrowthLaws.h).
    float wholeStem = 1.0f;     ///< Modulus of a living stem / elasticModulus.
    float branchModulus = 1.0f; ///< Modulus of branches / of the trunk.
    float modulusPower = 0.0f;  ///< Exponent of the slenderness in the modulus.
    float anchorage = 0.0f;     ///< Overturning moment / stem mass, N m/kg; 0 is rigid ground.
    WoodAllometry branchWood = WoodAllometry::Drawn; ///< Source of the mass of branches.

    // Strength of a stem.
    float bendingStrength = 0.0f; ///< Modulus of rupture of clear green wood, Pa; 0 if unknown.
    float knotFactor = 1.0f;      ///< Share of bendingStrength left by knots.
};

/// Height law: scale * diameter^power, metres, with the diameter at breast height. The law is unknown if the
/// scale is 0. Spreads, here and of the crown, are standard deviations of logarithms. With the law, the
/// distribution of diameters, which is log-normal, gives a diameter from a height.
struct HeightAllometry {
    float scale = 0.0f;               ///< In a forest.
    float power = 0.6f;               ///< In a forest.
    float spread = 0.0f;              ///< In a forest.
    float openScale = 0.0f;           ///< In the open.
    float openPower = 0.6f;           ///< In the open.
    float openSpread = 0.0f;          ///< In the open.
    float diameter = 0.25f;           ///< Median of the diameters in forests, metres.
    float diameterSpread = 0.62f;     ///< Of the diameters in forests.
    float openDiameter = 0.25f;       ///< Median of the diameters in the open, metres.
    float openDiameterSpread = 0.72f; ///< Of the diameters in the open.
    float largest = 0.0f; ///< Tallest measured tree, metres, which limits estimates; 0 if unknown.
    std::string source;   ///< Source of these numbers; informational.
};

/// Crown laws: width = base + perDiameter * diameter at breast height, depth = depth + depthPerHeight *
/// height, metres. A law is unknown if both of its numbers are 0.
struct CrownAllometry {
    float base = 0.0f;            ///< In a forest, metres.
    float perDiameter = 0.0f;     ///< In a forest.
    float openBase = 0.0f;        ///< In the open, metres.
    float openPerDiameter = 0.0f; ///< In the open.
    float spread = 0.0f;          ///< In a forest.
    float openSpread = 0.0f;      ///< In the open.
    float depth = 0.0f; ///< In a forest, from the lowest green bough to the top; not used in the open.
    float depthPerHeight = 0.0f; ///< In a forest.
    float largest = 0.0f;        ///< Widest measured crown, metres, which limits estimates; 0 if unknown.
};

/// Motion of branches under the laws of the thesis (§3.1, appendix B); `modal` uses only maxAngle. Angles are
/// in radians.
struct BranchParameters {
    float maxAngle = 0.5f;       ///< Largest rotation about either axis.
    float partialSteps = 24.0f;  ///< `NUMB`: partial steps to reach a new angle.
    float levelFactor = 0.0f;    ///< `factor`: added to the load per branch level (§3.1.2), m/s.
    float noiseFrequency = 0.7f; ///< Frequency of the load's noise, Hz.
};

/// Flutter of leaf clusters (§3.2, appendix D) and their turn downwind. Angles are in radians.
struct LeafMotion {
    float maxAngleX = 0.35f;     ///< `maxMotionAngleX`, about the normal of the leaf (thesis Z).
    float maxAngleZ = 0.35f;     ///< `maxMotionAngleZ`, about the leaf's X axis.
    float maxRotation = 0.6f;    ///< `maxRotationAngle`, about the petiole.
    float partialSteps = 6.0f;   ///< `NUM`: partial steps to reach a new angle.
    float factor = 1.0f;         ///< `fact`: factor on the largest angles.
    float linkedFactor = 0.7f;   ///< `linkedFactor`: rotation about the petiole / swing of maxAngleX.
    float noiseFrequency = 1.3f; ///< Frequency of the flutter, Hz.
    float size = 0.06f;          ///< Width of a leaf or leaflet, metres (law `modal`).
    float tremble = 1.0f;        ///< Factor on the trembling of single leaves (law `modal`).
    float maxDownwind = 0.8f;    ///< Largest downwind turn of a petiole across the wind (law `modal`).
    float shootSway = 1.0f;      ///< Factor on the sway of thin bough ends (law `modal`).
};

/// Largest number of distinct models of a species.
constexpr int maxShapes = 64;

/// A species: growth, mechanical properties, motion and appearance of its trees.
///
/// A default-constructed one is the tree of the thesis, on which files of version 1.0 build. Start from a
/// built-in species instead (io/SpeciesCatalogue.h), whose values come from measured trees:
///
///     Species hedge = *findSpecies("oak");
///     hedge.name = "hedge oak";
///     hedge.aliases.clear();
///     hedge.shapes = 8;
struct Species {
    std::string name;                 ///< Common name, as in files.
    std::vector<std::string> aliases; ///< Other names, common and scientific.
    std::string source;               ///< Source of the numbers; informational.
    TreeParameters tree;              ///< Shape of the trees.
    int shapes = 4;                   ///< Number of distinct models that all trees of the species share.
    HeightAllometry height;           ///< Height from the stem diameter.
    CrownAllometry crown;             ///< Crown width from stem diameter, depth from height.
    WoodParameters wood;              ///< Mechanical properties.
    BranchParameters branch;          ///< Motion of single branches.
    LeafMotion leaf;                  ///< Flutter of the leaves.
    Appearance appearance;            ///< Colours, leaves and bark.
};

} // namespace osgTreeWind
