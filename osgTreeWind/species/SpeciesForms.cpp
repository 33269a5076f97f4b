// SPDX-License-Identifier: MIT
#include <osgTreeWind/species/SpeciesForms.h>

#include <glm/trigonometric.hpp>

namespace osgTreeWind {

namespace {

/// An angle of the tables below, degrees.
float deg(float angle) {
    return glm::radians(angle);
}

/// Of the whole tree: metres, shares of its height.
struct Crown {
    float height, diameter, width; ///< Diameter at breast height.
    CrownOutline shape;
    float base, trunk;
};

/// Degrees.
struct Angles {
    float first, last, rise, riseOutside;
};

TreeParameters treeOf(const Crown& crown, const Angles& boughs, const Angles& branches, const Angles& twigs) {
    TreeParameters form;
    GrownTreeParameters& tree = form.grown.emplace();
    tree.height = crown.height;
    tree.crownWidth = crown.width;
    tree.shape = crown.shape;
    tree.crownBase = crown.base;
    tree.trunk = crown.trunk;
    tree.radius = 0.5f * crown.diameter;
    const auto turn = [](GrownBranches& kind, const Angles& angles) {
        kind.inclination = deg(angles.first);
        kind.inclinationEnd = deg(angles.last);
        kind.rise = deg(angles.rise);
        kind.riseOutside = deg(angles.riseOutside);
    };
    turn(tree.boughs, boughs);
    turn(tree.branches, branches);
    turn(tree.twigs, twigs);
    LeafParameters& leaves = form.leaves;
    leaves.clusters = 1500;
    leaves.bare = 0.4f;
    leaves.length = 0.45f;
    leaves.width = 0.36f;
    return form;
}

/// A broadleaf: its trunk dissolves into limbs.
TreeParameters broadleaf(const Crown& crown, const Angles& boughs, const Angles& branches,
                         const Angles& twigs, float crook, float leafAngle, float droop) {
    TreeParameters form = treeOf(crown, boughs, branches, twigs);
    GrownTreeParameters& tree = *form.grown;
    tree.trunkUnits = 4;
    tree.trunkTaper = 0.55f;
    tree.trunkCrook = 0.2f * crook;
    tree.forks = 3;
    tree.forkInclination = deg(28.0f);
    tree.boughs.count = 16;
    tree.boughs.crook = crook;
    tree.boughs.taper = 0.35f;
    tree.boughs.lengthVariation = 0.15f;
    tree.branches.count = 7;
    tree.branches.start = 0.2f;
    tree.branches.length = 0.75f;
    tree.branches.lengthVariation = 0.3f;
    tree.branches.crook = crook;
    tree.twigs.count = 3;
    tree.twigs.start = 0.2f;
    tree.twigs.length = 0.8f;
    tree.twigs.lengthVariation = 0.3f;
    tree.twigs.crook = 0.6f * crook;
    form.leaves.inclination = deg(leafAngle);
    form.leaves.droop = droop;
    return form;
}

/// A conifer: boughs up a straight trunk that goes on to the top; branches on their left and right.
TreeParameters conifer(const Crown& crown, int boughs, const Angles& bough, const Angles& branches,
                       float flat) {
    TreeParameters form = treeOf(crown, bough, branches, {});
    GrownTreeParameters& tree = *form.grown;
    tree.trunkUnits = 8;
    tree.trunkTaper = 0.2f;
    tree.trunkCrook = 0.02f;
    tree.forks = 1;
    tree.forkInclination = 0.0f;
    tree.boughs.count = boughs;
    tree.boughs.crook = 0.06f;
    tree.boughs.sections = 1.2f;
    tree.boughs.power = 1.4f;
    tree.boughs.taper = 0.4f;
    tree.boughs.lengthVariation = 0.1f;
    tree.boughs.inclinationVariation = 0.12f;
    tree.branches.count = 5;
    tree.branches.start = 0.25f;
    tree.branches.length = 0.5f;
    tree.branches.flat = flat;
    tree.branches.crook = 0.08f;
    tree.branches.sections = 0.6f;
    tree.twigs.count = 0;
    form.leaves.clusters = 1200;
    form.leaves.bare = 0.1f;
    form.leaves.inclination = deg(45.0f);
    return form;
}

/// A pine: a long bare stem, few boughs, tufts at their ends.
TreeParameters pine(const Crown& crown, int boughs, const Angles& bough, const Angles& branches,
                    float crook) {
    TreeParameters form = conifer(crown, boughs, bough, branches, 0.2f);
    GrownTreeParameters& tree = *form.grown;
    tree.whorl = 3;
    tree.boughs.sections = 1.2f;
    tree.boughs.crook = crook;
    tree.branches.count = 8;
    tree.branches.length = 0.55f;
    tree.branches.crook = crook;
    form.leaves.bare = 0.45f;
    form.leaves.length = form.leaves.width = 0.5f;
    form.leaves.droop = -0.2f;
    form.leaves.inclination = 0.0f;
    return form;
}

TreeParameters palm() {
    TreeParameters form =
        treeOf({14.0f, 0.35f, 4.8f, CrownOutline::Cylinder, 0.8f, 0.84f}, {135, 15, -15, -70}, {}, {});
    GrownTreeParameters& tree = *form.grown;
    tree.trunkUnits = 5;
    tree.trunkTaper = 0.75f;
    tree.trunkCrook = 0.1f;
    tree.forks = 0;
    tree.crownBase = 0.81f;
    tree.boughs.count = 48;
    tree.boughs.sections = 0.4f;
    tree.boughs.crook = 0.05f;
    tree.branches.count = tree.twigs.count = 0;
    form.leaves.clusters = 480;
    form.leaves.length = 1.0f;
    form.leaves.width = 0.8f;
    form.leaves.bare = 0.25f;
    form.leaves.droop = 0.4f;
    return form;
}

} // namespace

TreeParameters speciesForm(SpeciesForm form) {
    using S = CrownOutline;
    TreeParameters tree;
    switch (form) {
    case SpeciesForm::Spruce: // boughs hang and turn up at their ends, branches hang from them
        tree = conifer({18, 0.42f, 6.6f, S::Cone, 0.08f, 0.92f}, 60, {100, 55, -22, 45}, {55, 45, -50, -30},
                       0.9f);
        tree.leaves.droop = 0.7f;
        break;
    case SpeciesForm::SitkaSpruce:
        tree =
            conifer({18, 0.42f, 6.4f, S::Cone, 0.06f, 0.9f}, 60, {88, 50, 0, 15}, {55, 45, -30, -20}, 0.9f);
        tree.leaves.droop = 0.4f;
        break;
    case SpeciesForm::WhiteSpruce:
        tree =
            conifer({15, 0.36f, 5.0f, S::Cone, 0.05f, 0.92f}, 60, {95, 50, -5, 30}, {50, 45, -10, 0}, 0.8f);
        tree.leaves.droop = 0.2f;
        break;
    case SpeciesForm::DouglasFir:
        tree = conifer({20, 0.46f, 7.2f, S::Cone, 0.15f, 0.92f}, 55, {92, 45, -10, 35}, {50, 40, -25, -15},
                       0.7f);
        tree.leaves.droop = 0.4f;
        break;
    case SpeciesForm::Fir: // flat tiers
        tree = conifer({18, 0.42f, 6.4f, S::Cone, 0.1f, 0.92f}, 60, {88, 60, 0, 5}, {55, 50, 0, 0}, 1.0f);
        tree.grown->whorl = 6;
        tree.leaves.droop = 0.0f;
        tree.leaves.inclination = deg(25);
        break;
    case SpeciesForm::BalsamFir: // a spire
        tree = conifer({15, 0.34f, 4.6f, S::Cone, 0.05f, 0.92f}, 60, {88, 55, 0, 10}, {55, 50, 0, 0}, 1.0f);
        tree.grown->whorl = 6;
        tree.leaves.droop = 0.0f;
        tree.leaves.inclination = deg(25);
        break;
    case SpeciesForm::Hemlock:
        tree = conifer({18, 0.42f, 7.0f, S::Cone, 0.08f, 0.94f}, 58, {80, 45, -15, -35}, {50, 45, -25, -30},
                       0.9f);
        tree.grown->forkInclination = deg(15);
        tree.leaves.droop = 0.5f;
        tree.leaves.inclination = deg(25);
        break;
    case SpeciesForm::Larch: // open, twigs hang
        tree =
            conifer({18, 0.4f, 6.6f, S::Cone, 0.15f, 0.92f}, 50, {95, 55, -10, 30}, {60, 55, -70, -20}, 0.6f);
        tree.leaves.inclination = 0.0f;
        tree.leaves.droop = 0.3f;
        break;
    case SpeciesForm::Conifer:
        tree =
            conifer({18, 0.42f, 6.6f, S::Cone, 0.2f, 0.92f}, 60, {92, 50, -8, 25}, {55, 45, -25, -15}, 0.8f);
        tree.leaves.droop = 0.3f;
        break;
    case SpeciesForm::ScotsPine: // an umbrella on a long bare stem
        tree = pine({15, 0.34f, 8.2f, S::Sphere, 0.47f, 0.86f}, 20, {85, 55, 5, 20}, {55, 45, 20, 20}, 0.45f);
        tree.grown->forks = 4;
        tree.grown->forkInclination = deg(38);
        tree.grown->trunkTaper = 0.3f;
        tree.grown->boughs.sections = 1.5f;
        break;
    case SpeciesForm::LodgepolePine:
        tree = pine({16, 0.3f, 5.4f, S::Cone, 0.22f, 0.9f}, 28, {80, 50, 10, 25}, {50, 40, 25, 20}, 0.2f);
        break;
    case SpeciesForm::CorsicanPine:
        tree =
            pine({16, 0.38f, 7.0f, S::TendFlame, 0.22f, 0.9f}, 30, {85, 55, 0, 25}, {50, 40, 25, 20}, 0.2f);
        break;
    case SpeciesForm::RadiataPine:
        tree = pine({18, 0.42f, 8.4f, S::Hemisphere, 0.18f, 0.9f}, 26, {75, 40, 10, 20}, {55, 40, 20, 20},
                    0.35f);
        tree.grown->boughs.sections = 0.9f;
        break;
    case SpeciesForm::Birch: // slender, twigs hang
        tree = broadleaf({15, 0.32f, 8.0f, S::TendFlame, 0.22f, 0.88f}, {50, 35, 10, -35}, {45, 40, -10, -60},
                         {50, 50, -90, -60}, 0.25f, 56, 0.7f);
        tree.grown->trunkTaper = 0.3f;
        tree.grown->forks = 2;
        tree.grown->boughs.count = 18;
        break;
    case SpeciesForm::Beech: // a dense dome of boughs that arch out
        tree = broadleaf({16, 0.52f, 11.2f, S::Sphere, 0.14f, 0.75f}, {62, 30, 5, -20}, {50, 45, -5, -10},
                         {50, 45, 0, 0}, 0.25f, 18, 0.1f);
        tree.grown->boughs.count = 20;
        tree.grown->branches.flat = tree.grown->twigs.flat = 0.6f;
        break;
    case SpeciesForm::Oak: // few wide crooked limbs
        tree = broadleaf({15, 0.5f, 10.8f, S::Sphere, 0.16f, 0.55f}, {80, 50, 15, 5}, {60, 50, 20, 0},
                         {60, 50, 10, 0}, 0.75f, 35, 0.1f);
        tree.grown->boughs.count = 13;
        tree.grown->branches.count = 8;
        tree.grown->forks = 4;
        tree.grown->forkInclination = deg(38);
        break;
    case SpeciesForm::RedOak:
        tree = broadleaf({16, 0.48f, 10.8f, S::Sphere, 0.2f, 0.65f}, {75, 45, 10, 10}, {50, 45, 15, 5},
                         {50, 45, 10, 0}, 0.35f, 27, 0.2f);
        break;
    case SpeciesForm::Ash: // open, limbs ascend, their ends turn up
        tree = broadleaf({17, 0.44f, 9.6f, S::Sphere, 0.25f, 0.6f}, {50, 35, -5, 30}, {45, 40, -10, 45},
                         {45, 40, 0, 40}, 0.25f, 30, 0.2f);
        tree.grown->boughs.count = 13;
        tree.grown->branches.count = 8;
        break;
    case SpeciesForm::Sycamore: // a broad dense dome
        tree = broadleaf({15, 0.52f, 11.0f, S::Sphere, 0.17f, 0.62f}, {70, 40, 15, 5}, {50, 45, 10, 0},
                         {50, 45, 5, 0}, 0.3f, 27, 0.2f);
        tree.grown->boughs.count = 18;
        break;
    case SpeciesForm::RedMaple:
        tree = broadleaf({15, 0.4f, 8.6f, S::TendFlame, 0.2f, 0.65f}, {50, 30, 10, 15}, {45, 40, 15, 10},
                         {45, 40, 10, 5}, 0.25f, 27, 0.3f);
        break;
    case SpeciesForm::NorwayMaple: // dense, round
        tree = broadleaf({13, 0.46f, 10.4f, S::Sphere, 0.16f, 0.6f}, {65, 40, 10, 10}, {50, 45, 10, 5},
                         {50, 45, 5, 0}, 0.25f, 27, 0.3f);
        tree.grown->boughs.count = 18;
        break;
    case SpeciesForm::Aspen: // a small round crown on a slender stem
        tree = broadleaf({14, 0.26f, 4.8f, S::Sphere, 0.4f, 0.85f}, {65, 40, 5, 15}, {50, 45, 10, 5},
                         {50, 45, 0, 0}, 0.35f, 37, 0.4f);
        tree.grown->trunkTaper = 0.35f;
        tree.grown->boughs.count = 15;
        break;
    case SpeciesForm::Lime: // heart-shaped and dense, lower boughs arch down
        tree = broadleaf({15.5f, 0.56f, 9.4f, S::TendFlame, 0.1f, 0.85f}, {75, 30, 5, -45},
                         {50, 45, -10, -20}, {50, 45, -20, -10}, 0.3f, 30, 0.4f);
        tree.grown->boughs.count = 22;
        tree.grown->boughs.sections = 1.2f;
        tree.grown->boughs.taper = 0.5f;
        tree.grown->twigs.count = 2;
        break;
    case SpeciesForm::Poplar: // a column of upright boughs
        tree = broadleaf({22, 0.42f, 3.6f, S::TendFlame, 0.04f, 0.9f}, {22, 14, 12, 0}, {22, 18, 15, 0},
                         {25, 20, 10, 0}, 0.15f, 45, 0.2f);
        tree.grown->trunkTaper = 0.3f;
        tree.grown->trunkUnits = 6;
        tree.grown->forks = 2;
        tree.grown->forkInclination = deg(8);
        tree.grown->boughs.count = 30;
        tree.grown->boughs.inclinationVariation = deg(4);
        tree.grown->branches.count = 8;
        tree.grown->branches.start = 0.1f;
        tree.grown->branches.length = 0.35f;
        tree.grown->twigs.count = 2;
        break;
    case SpeciesForm::Plane:
        tree = broadleaf({18, 0.56f, 11.4f, S::Sphere, 0.2f, 0.55f}, {65, 40, 10, -25}, {50, 45, 0, -25},
                         {50, 45, -10, -20}, 0.45f, 30, 0.4f);
        tree.grown->boughs.count = 11;
        tree.grown->forks = 4;
        break;
    case SpeciesForm::HoneyLocust: // open and spreading
        tree = broadleaf({13, 0.4f, 10.0f, S::Sphere, 0.22f, 0.5f}, {62, 45, 10, -20}, {55, 50, -5, -10},
                         {50, 45, -10, -15}, 0.5f, 30, 0.3f);
        tree.grown->boughs.count = 12;
        tree.grown->forks = 4;
        tree.grown->forkInclination = deg(32);
        tree.grown->branches.flat = 0.5f;
        break;
    case SpeciesForm::HorseChestnut: // a dense dome; boughs hang and turn up at their ends
        tree = broadleaf({15, 0.5f, 10.6f, S::Sphere, 0.12f, 0.65f}, {75, 40, -15, 10}, {50, 45, -20, 30},
                         {50, 45, -10, 30}, 0.25f, 25, 0.5f);
        tree.grown->boughs.count = 18;
        break;
    case SpeciesForm::Ginkgo: // an open cone of stiff ascending boughs
        tree = broadleaf({15, 0.36f, 7.4f, S::TaperedCylinder, 0.2f, 0.88f}, {60, 40, 5, 5}, {45, 40, 15, 5},
                         {45, 40, 10, 0}, 0.2f, 40, 0.1f);
        tree.grown->trunkTaper = 0.25f;
        tree.grown->forks = 1;
        tree.grown->boughs.count = 20;
        tree.grown->branches.count = 6;
        tree.grown->twigs.count = 2;
        break;
    case SpeciesForm::Palm:
        tree = palm();
        break;
    case SpeciesForm::Broadleaf:
        tree = broadleaf({14, 0.42f, 8.8f, S::Sphere, 0.2f, 0.62f}, {65, 40, 10, 10}, {50, 45, 10, 0},
                         {50, 45, 5, 0}, 0.35f, 35, 0.3f);
        break;
    }
    GrownTreeParameters& wood = *tree.grown; // the diameters above are those at breast height
    wood.radius /= 1.0f - (1.0f - wood.trunkTaper) * 1.3f / (wood.trunk * wood.height);
    return tree;
}

} // namespace osgTreeWind
