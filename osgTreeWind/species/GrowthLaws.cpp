// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/GrowthLaws.h>

#include <osgTreeWind/base/PortableMath.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// Crown base / height of a tree in a forest; 0 if unknown.
float crownBaseRatio(const CrownAllometry& law, float height) {
    const float depth = law.depth + law.depthPerHeight * height;
    return depth > 0.0f ? std::max(1.0f - depth / height, 0.0f) : 0.0f;
}

/// Size of a tree in a closed forest that is as high as one in the open.
GrowthGoal forestGrownSize(const Species& species) {
    GrowthGoal size = species.tree.growth->size;
    const HeightAllometry& height = species.height;
    if (!(height.scale > 0.0f) || !(height.power > 0.0f))
        return size;
    size.trunkDiameter = math::pow(size.height / height.scale, 1.0f / height.power);
    const TreeSize crowned = withCrown({size.height, size.trunkDiameter, 0.0f}, species.crown, false);
    if (crowned.crownWidth > 0.0f)
        size.crownWidth = crowned.crownWidth;
    return size;
}

/// Scales the known size of a tree to another height.
GrowthGoal scaleToHeight(float height, const GrowthGoal& known, const Species& species, bool openGrown) {
    const float ratio = height / known.height;
    const float power = openGrown ? species.height.openPower : species.height.power;
    const float scale = openGrown ? species.height.openScale : species.height.scale;
    const auto crownWidthOf = [&](float diameter) {
        return withCrown({0.0f, diameter, 0.0f}, species.crown, openGrown).crownWidth;
    };
    GrowthGoal goal{height, known.trunkDiameter * ratio, known.crownWidth * ratio};
    if (scale > 0.0f && power > 0.0f)
        goal.trunkDiameter = known.trunkDiameter * math::pow(ratio, 1.0f / power);
    const float before = crownWidthOf(known.trunkDiameter), after = crownWidthOf(goal.trunkDiameter);
    if (before > 0.0f && after > 0.0f)
        goal.crownWidth = known.crownWidth * after / before;
    return goal;
}

// The modulus depends on the slenderness within its measured range; clear wood is cut from typical trees.
constexpr double modulusMinSlenderness = 50.0, typicalSlenderness = 80.0, modulusMaxSlenderness = 110.0;

// A root plate turns by a quarter of a degree under 1/2.5 of its overturning moment.
constexpr double rootMomentShare = 1.0 / 2.5, rootRotation = 0.25 * glm::pi<double>() / 180.0;
constexpr double stemForm = 0.45; // volume of a stem / of a cylinder with its diameter at breast height

constexpr double stemTaper = 0.6; // power of the distance to the top in the radius, as of drawn trunks

// Dry mass of branches per trunk cross-section of a tree of 20 cm and typical slenderness, kg/m^2, exponents
// of slenderness and diameter, and dry kg per fresh m^3. Fits to trees of BAAD (Falster et al. 2015): 769
// conifers of 10 cm or more and 1312 broadleaves of 5 cm or more.
struct BranchFit {
    double mass, slendernessPower, diameterPower, basicDensity;
};
constexpr BranchFit coniferBranches{488.0, -0.91, 0.40, 400.0}, broadleafBranches{876.0, -1.06, 0.33, 580.0};
constexpr double branchMinSlenderness = 33.0, branchMaxSlenderness = 150.0; // range of the fits

constexpr double maxBranchFactor = 3.0; // limit of branch wood / drawn branch wood, and of the inverse

double sectionOf(double diameter) {
    return 0.25 * glm::pi<double>() * diameter * diameter;
}

double stemMass(const WoodParameters& wood, double diameter, double height) {
    return stemForm * wood.density * sectionOf(diameter) * height;
}

/// Mass of a stem that tapers up to the top of the tree, less the trunk: a trunk that divides ends below.
double upperStemMass(const WoodParameters& wood, double diameter, double height, double trunk) {
    if (!(height > 0.0))
        return 0.0;
    const double breast = breastHeight(static_cast<float>(height));
    const double whole = wood.density * sectionOf(diameter) * height / (2.0 * stemTaper + 1.0) *
                         math::pow(height / (height - breast), 2.0 * stemTaper);
    return std::max(whole - trunk, 0.0);
}

double branchMass(const BranchFit& fit, const WoodParameters& wood, double diameter, double height) {
    if (!(diameter > 0.0))
        return 0.0;
    const double slenderness = std::clamp(height / diameter, branchMinSlenderness, branchMaxSlenderness);
    return fit.mass * wood.density / fit.basicDensity * sectionOf(diameter) *
           math::pow(slenderness / typicalSlenderness, fit.slendernessPower) *
           math::pow(diameter / 0.2, fit.diameterPower);
}

/// Mass of a broadleaf without leaves (hard maple, oak, hickory and beech).
double broadleafMass(const WoodParameters& wood, double diameter) {
    // Jenkins et al. 2003: exp(a + b ln d), exp(a + b / d), d in cm, kg of dry mass and shares of it.
    const double d = std::max(100.0 * diameter, 2.5);
    const double leaves = math::exp(-4.0813 + 5.8816 / d);
    const double dry = math::exp(-2.0127 + 2.4342 * math::log(d)) * (1.0 - leaves);
    return dry * wood.density / broadleafBranches.basicDensity;
}

} // namespace

TreeSize withCrown(TreeSize size, const CrownAllometry& crown, bool openGrown) {
    if (size.crownWidth > 0.0f || !(size.trunkDiameter > 0.0f))
        return size;
    size.crownWidth = openGrown ? crown.openBase + crown.openPerDiameter * size.trunkDiameter
                                : crown.base + crown.perDiameter * size.trunkDiameter;
    return size;
}

double lawDiameter(double diameter) {
    return diameter <= 1.0 ? diameter : 2.0 - math::exp(1.0 - diameter);
}

float limitToRecord(float size, float largest) {
    return largest > 0.0f ? std::min(size, largest) : size;
}

TreeSize completeSize(TreeSize size, const Species& species, bool openGrown) {
    const bool hasHeight = size.height > 0.0f, hasTrunk = size.trunkDiameter > 0.0f,
               hasCrown = size.crownWidth > 0.0f;
    const auto diameter = static_cast<float>(lawDiameter(size.trunkDiameter));
    if (!hasCrown)
        size.crownWidth = limitToRecord(
            withCrown({0.0f, diameter, 0.0f}, species.crown, openGrown).crownWidth, species.crown.largest);
    const bool isComplete = hasHeight && hasTrunk && size.crownWidth > 0.0f;
    if (isComplete || !growsByLight(species) || !(hasHeight || hasTrunk))
        return size;
    const GrowthGoal known = openGrown ? species.tree.growth->size : forestGrownSize(species);
    const float power = openGrown ? species.height.openPower : species.height.power;
    if (!hasHeight)
        size.height = limitToRecord(
            known.height * math::pow(diameter / known.trunkDiameter, power > 0.0f ? power : 1.0f),
            species.height.largest);
    const GrowthGoal usual = scaleToHeight(size.height, known, species, openGrown);
    if (!hasTrunk)
        size.trunkDiameter = usual.trunkDiameter;
    if (!(size.crownWidth > 0.0f))
        size.crownWidth = limitToRecord(usual.crownWidth, species.crown.largest);
    return size;
}

float usualHeight(const Species& species) {
    const TreeParameters& tree = species.tree;
    return tree.growth ? tree.growth->size.height : tree.palm ? tree.palm->height : 0.0f;
}

bool growsByLight(const Species& species) {
    return species.tree.growth && !species.tree.scans;
}

TreeParameters growthOf(const Species& species, bool openGrown) {
    TreeParameters tree = species.tree;
    if (openGrown || !growsByLight(species))
        return tree;
    GrowthParameters& growth = *tree.growth;
    growth.size = forestGrownSize(species);
    growth.site.shade = 1.0f;
    growth.site.distance = growth.size.crownWidth;
    growth.habit.cleanStem =
        std::max(growth.habit.cleanStem, crownBaseRatio(species.crown, growth.size.height));
    return tree;
}

TreeParameters growthOf(const Species& species, bool openGrown, bool atEdge, float height) {
    TreeParameters tree = growthOf(species, openGrown);
    if (!tree.growth)
        return tree;
    tree.growth->size = scaleToHeight(height, tree.growth->size, species, openGrown);
    if (!openGrown)
        tree.growth->site.distance = tree.growth->size.crownWidth;
    if (atEdge && !openGrown)
        tree.growth->site.openSide = 0.0f;
    return tree;
}

double stemModulus(const WoodParameters& wood, double slenderness) {
    return wood.elasticModulus * wood.wholeStem *
           math::pow(std::clamp(slenderness, modulusMinSlenderness, modulusMaxSlenderness) /
                         typicalSlenderness,
                     static_cast<double>(wood.modulusPower));
}

double branchWoodMass(const WoodParameters& wood, double diameter, double height, double trunk,
                      double drawn) {
    if (wood.branchWood == WoodAllometry::Drawn)
        return drawn;
    const double upperStem = upperStemMass(wood, diameter, height, trunk);
    if (wood.branchWood == WoodAllometry::Conifer)
        return upperStem + branchMass(coniferBranches, wood, diameter, height);
    return std::clamp(std::max(broadleafMass(wood, diameter) - trunk,
                               upperStem + branchMass(broadleafBranches, wood, diameter, height)),
                      drawn / maxBranchFactor, maxBranchFactor * drawn);
}

double overturningMoment(const WoodParameters& wood, double diameter, double height) {
    return wood.anchorage * stemMass(wood, diameter, height);
}

double breakingMoment(const WoodParameters& wood, double diameter) {
    return wood.knotFactor * wood.bendingStrength * glm::pi<double>() * diameter * diameter * diameter / 32.0;
}

double strainPerMoment(double modulus, double diameter) {
    return 32.0 / (glm::pi<double>() * modulus * diameter * diameter * diameter);
}

double rootCompliance(const WoodParameters& wood, double diameter, double height) {
    const double moment = rootMomentShare * wood.anchorage * stemMass(wood, diameter, height);
    return moment > 0.0 ? rootRotation / moment : 0.0;
}

} // namespace osgTreeWind
