// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/Archetype.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/SharedValues.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/motion/modal/ModalLean.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace osgTreeWind {

namespace {

// Distance between size classes: of logarithms, and of the share of leaves.
constexpr float heightStep = 0.7f, supportStep = 0.6f, widthStep = 0.2f, leavesStep = 0.25f;

JointTree jointsOf(const TreeForm& tree) {
    return makeJointTree(*tree.model, tree.scale, *tree.species, tree.leaves);
}

float relativeWidth(const TreeScale& scale) {
    return scale.axes.x / scale.axes.z;
}

float relativeGirth(const TreeScale& scale) {
    return scale.radius / scale.axes.z;
}

int steps(float value, float step) {
    return static_cast<int>(std::lround(std::clamp(value / step, -100.0f, 100.0f)));
}

/// Logarithms of growth quantities that do not follow from a tree's scale; leaves over the mass of wood at
/// that scale.
SizePowers growthOf(const TreeForm& tree, float leaves) {
    const WoodParameters& wood = tree.species->wood;
    double trunk = 0.0, drawn = 0.0, height = 0.0;
    for (const BranchUnit& unit : tree.model->skeleton.units) {
        const ScaledUnit scaled(unit, tree.scale);
        (unit.level > 0 ? drawn : trunk) += static_cast<double>(wood.density * scaled.volume());
        height = std::max(height, static_cast<double>(scaled.base.z + scaled.span.z));
    }
    const double diameter = std::max(breastDiameter(*tree.model, tree.scale), 1.0e-6);
    const glm::vec3& axes = tree.scale.axes;
    SizePowers logs;
    logs.modulus = static_cast<float>(math::log(stemModulus(wood, height / diameter)));
    logs.branches =
        drawn > 0.0
            ? static_cast<float>(math::log(branchWoodMass(wood, diameter, height, trunk, drawn) / drawn))
            : 0.0f;
    logs.width = math::log(relativeWidth(tree.scale));
    logs.leaves = leaves > 0.0f ? math::log(leaves / (tree.scale.radius * tree.scale.radius * axes.z)) : 0.0f;
    return logs;
}

constexpr double logStep = 0.1; // change of a logarithm

/// Sets the powers with which modal stiffness follows one quantity, from a tree with e^change as much of it.
void addStiffnessPowers(std::vector<ModalModel>& models, const JointTree& other, double change,
                        float SizePowers::*size) {
    const std::vector<double> ratios = stiffnessRatios(models.front(), other);
    for (ModalModel& model : models)
        for (std::size_t k = 0; k < model.modes.size(); ++k)
            model.modes[k].stiffness.*size = static_cast<float>(math::log(ratios[k]) / change);
}

void addPowers(std::vector<ModalModel>& models, const JointTree& other, double change,
               float SizePowers::*size) {
    addStiffnessPowers(models, other, change, size);
    const std::vector<double> ratios = massRatios(models.front(), other);
    for (ModalModel& model : models)
        for (std::size_t k = 0; k < model.modes.size(); ++k)
            model.modes[k].mass.*size = static_cast<float>(math::log(ratios[k]) / change);
}

/// The joints of the tree with `factor` times as much wood in its branches.
JointTree withBranchWood(const TreeForm& tree, double factor) {
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    TreeForm bare = tree;
    bare.leaves = 0.0f;
    JointTree joints = jointsOf(tree);
    const JointTree wood = jointsOf(bare);
    for (std::size_t i = 0; i < joints.points.size(); ++i)
        if (units[joints.points[i].link].level > 0)
            joints.points[i].mass += (factor - 1.0) * wood.points[i].mass;
    if (tree.species->wood.branchWood ==
        WoodAllometry::Conifer) // a drawn branch represents several side by side, which share stiffness
        for (std::size_t i = 0; i < units.size(); ++i)
            if (units[i].level > 0)
                joints.links[i].stiffness *= factor;
    return joints;
}

/// The joints of the tree with a crown `factor` times wider, and the same wood in its branches.
JointTree withWidth(const TreeForm& tree, float factor) {
    TreeForm other = tree;
    other.scale.axes.x *= factor;
    other.scale.axes.y *= factor;
    return withBranchWood(other, math::exp(static_cast<double>(growthOf(tree, 0.0f).branches -
                                                               growthOf(other, 0.0f).branches)));
}

void addPowers(std::vector<ModalModel>& models, const TreeForm& tree) {
    const double more = math::exp(logStep);
    Species other = *tree.species;
    other.wood.elasticModulus *= static_cast<float>(more);
    TreeForm changed = tree;
    changed.species = &other;
    addStiffnessPowers(models, jointsOf(changed), logStep, &SizePowers::modulus);
    other = *tree.species;
    other.wood.anchorage *= static_cast<float>(more);
    addStiffnessPowers(models, jointsOf(changed), logStep, &SizePowers::roots);
    for (ModalModel& model : models) // the rest of the stiffness: branches that hold themselves up
        for (ModalModel::Mode& mode : model.modes)
            mode.stiffness.support = 1.0f - mode.stiffness.modulus - mode.stiffness.roots;
    addPowers(models, withBranchWood(tree, more), logStep, &SizePowers::branches);
    addPowers(models, withWidth(tree, static_cast<float>(more)), logStep, &SizePowers::width);
    changed = tree;
    changed.leaves *= static_cast<float>(1.0 / more);
    addPowers(models, jointsOf(changed), -logStep, &SizePowers::leaves);
}

/// Logarithm of weight times length over wood stiffness.
float logSupport(const TreeScale& scale) {
    return math::log(scale.axes.z) - 2.0f * math::log(relativeGirth(scale));
}

} // namespace

TreeSizeClass sizeClassOf(const TreeForm& tree) {
    return {tree.model,
            tree.species,
            steps(math::log(tree.scale.axes.z), heightStep),
            steps(logSupport(tree.scale), supportStep),
            steps(math::log(relativeWidth(tree.scale)), widthStep),
            steps(tree.leaves, leavesStep)};
}

TreeForm typicalTree(const TreeSizeClass& sizeClass) {
    TreeForm tree{sizeClass.model, sizeClass.species, {}, leavesStep * static_cast<float>(sizeClass.leaves)};
    tree.scale.axes.z = math::exp(heightStep * static_cast<float>(sizeClass.height));
    const float girth = // logarithm of girth over height
        0.5f * (heightStep * static_cast<float>(sizeClass.height) -
                supportStep * static_cast<float>(sizeClass.support));
    tree.scale.radius = tree.scale.axes.z * math::exp(girth);
    tree.scale.axes.x = tree.scale.axes.y =
        tree.scale.axes.z * math::exp(widthStep * static_cast<float>(sizeClass.width));
    tree.scale.leaf = math::cbrt(tree.scale.axes.x * tree.scale.axes.y * tree.scale.axes.z);
    return tree;
}

Archetype::Archetype(const TreeForm& tree)
    : _scale(tree.scale), _leaves(tree.leaves),
      _leafArea(leafArea(*tree.model, tree.scale, *tree.species, tree.leaves)),
      _logs(growthOf(tree, _leafArea)) {
    const WoodParameters& wood = tree.species->wood;
    const ModalMaterial material{wood.dampingRatio, wood.streamlining, wood.streamlinedTo,
                                 tree.species->branch.maxAngle, wood.breezeStreamlining};
    const JointTree joints = jointsOf(tree);
    _models = makeModalModels(joints, material, {std::begin(details), std::end(details)});
    for (ModalModel& model : _models) {
        model.height = measureTree(*tree.model, tree.scale).height;
        model.leans = modalLeans(*tree.model, tree.scale, joints, model);
    }
    addPowers(_models, tree);
    _other[0] = nearestPatches(_models[0], 1.0f, _models[1], 1.0f);
    _other[1] = nearestPatches(_models[1], 1.0f, _models[0], 1.0f);
}

TreeFactors Archetype::factors(const TreeForm& tree, float heading) const {
    const float l = tree.scale.axes.z / _scale.axes.z, r = tree.scale.radius / _scale.radius;
    TreeFactors f;
    f.cosine = math::cos(heading);
    f.sine = math::sin(heading);
    f.length = l;
    f.omegaSquare = r * r / (l * l * l * l);
    const float leaves = leafArea(*tree.model, tree.scale, *tree.species, tree.leaves);
    const SizePowers logs = growthOf(tree, leaves);
    f.logs.modulus = logs.modulus - _logs.modulus;
    f.logs.branches = logs.branches - _logs.branches;
    f.logs.width = logs.width - _logs.width;
    f.logs.support = math::log(l * l * l / (r * r)); // weight times length over wood stiffness
    f.logs.roots = math::log(l * l / (r * r));       // weight over wood stiffness
    f.logs.leaves = leaves > 0.0f && _leafArea > 0.0f ? logs.leaves - _logs.leaves : 0.0f;
    f.stillDrag = _leafArea > 0.0f ? leaves / _leafArea : 0.0f;
    f.leafDrag = tree.species->wood.crownDrag > 0.0f && _leaves > 0.0f
                     ? l * tree.scale.axes.x / _scale.axes.x * tree.leaves / _leaves // outline
                     : f.stillDrag;
    return f;
}

std::shared_ptr<const Archetype> sharedArchetype(const TreeForm& tree) {
    static SharedConstants<std::pair<std::uint64_t, std::string>, Archetype> archetypes;
    if (tree.model->identity == 0)
        return std::make_shared<const Archetype>(tree);
    const glm::vec3& axes = tree.scale.axes;
    std::string form;
    for (const float number : {axes.x, axes.y, axes.z, tree.scale.radius, tree.scale.leaf, tree.leaves})
        form.append(reinterpret_cast<const char*>(&number), sizeof number);
    addKeyBytes(tree.species->wood, form);
    addKeyBytes(tree.species->branch, form);
    return archetypes.get({tree.model->identity, form},
                          [&] { return std::make_shared<const Archetype>(tree); });
}

} // namespace osgTreeWind
