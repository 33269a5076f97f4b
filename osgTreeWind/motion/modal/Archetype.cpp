// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/Archetype.h>

#include <osgTreeWind/base/SharedValues.h>
#include <osgTreeWind/model/MeasureTree.h>
#include <osgTreeWind/motion/laws/ScaledUnit.h>
#include <osgTreeWind/motion/laws/UnitLoads.h>
#include <osgTreeWind/motion/modal/JointTree.h>
#include <osgTreeWind/motion/modal/ModalLean.h>
#include <osgTreeWind/species/GrowthLaws.h>
#include <osgTreeWind/species/SpeciesFields.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

namespace osgTreeWind {

namespace {

// Steps between rungs: of logarithms, and of the leaves' share.
constexpr float heightStep = 0.7f, supportStep = 0.6f, widthStep = 0.2f, leavesStep = 0.25f;

JointTree jointsOf(const SwayingTree& tree) {
    return makeJointTree(*tree.model, tree.scale, *tree.species, tree.leaves);
}

float widthOver(const TreeScale& scale) {
    return scale.axes.x / scale.axes.z;
}

float girthOver(const TreeScale& scale) {
    return scale.radius / scale.axes.z;
}

int steps(float value, float step) {
    return static_cast<int>(std::lround(std::clamp(value / step, -100.0f, 100.0f)));
}

/// Logarithms of what growth gives to a tree beside its scale; of its leaves, over the mass of wood of that
/// scale.
SizePowers growthOf(const SwayingTree& tree, float leaves) {
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
    logs.modulus = static_cast<float>(std::log(stemModulus(wood, height / diameter)));
    logs.branches =
        drawn > 0.0
            ? static_cast<float>(std::log(branchWoodMass(wood, diameter, height, trunk, drawn) / drawn))
            : 0.0f;
    logs.width = std::log(widthOver(tree.scale));
    logs.leaves = leaves > 0.0f ? std::log(leaves / (tree.scale.radius * tree.scale.radius * axes.z)) : 0.0f;
    return logs;
}

constexpr double little = 0.1; // of a logarithm

/// The powers by which the modes follow one quantity: what is left on `other`, which has e^change as much of
/// it.
void addStiffnessPowers(std::vector<ModalModel>& models, const JointTree& other, double change,
                        float SizePowers::*size) {
    const std::vector<double> ratios = stiffnessRatios(models.front(), other);
    for (ModalModel& model : models)
        for (std::size_t k = 0; k < model.modes.size(); ++k)
            model.modes[k].stiffness.*size = static_cast<float>(std::log(ratios[k]) / change);
}

void addPowers(std::vector<ModalModel>& models, const JointTree& other, double change,
               float SizePowers::*size) {
    addStiffnessPowers(models, other, change, size);
    const std::vector<double> ratios = massRatios(models.front(), other);
    for (ModalModel& model : models)
        for (std::size_t k = 0; k < model.modes.size(); ++k)
            model.modes[k].mass.*size = static_cast<float>(std::log(ratios[k]) / change);
}

/// The tree with more wood in its branches.
JointTree withBranches(const SwayingTree& tree, double factor) {
    const std::vector<BranchUnit>& units = tree.model->skeleton.units;
    SwayingTree bare = tree;
    bare.leaves = 0.0f;
    JointTree joints = jointsOf(tree);
    const JointTree wood = jointsOf(bare);
    for (std::size_t i = 0; i < joints.points.size(); ++i)
        if (units[joints.points[i].link].level > 0)
            joints.points[i].mass += (factor - 1.0) * wood.points[i].mass;
    if (tree.species->wood.branchWood ==
        WoodAllometry::Conifer) // several side by side, which share stiffness
        for (std::size_t i = 0; i < units.size(); ++i)
            if (units[i].level > 0)
                joints.links[i].stiffness *= factor;
    return joints;
}

/// The tree with a crown as many times wider, and the same wood in its branches.
JointTree withWidth(const SwayingTree& tree, float factor) {
    SwayingTree other = tree;
    other.scale.axes.x *= factor;
    other.scale.axes.y *= factor;
    return withBranches(
        other, std::exp(static_cast<double>(growthOf(tree, 0.0f).branches - growthOf(other, 0.0f).branches)));
}

void addPowers(std::vector<ModalModel>& models, const SwayingTree& tree) {
    const double more = std::exp(little);
    Species other = *tree.species;
    other.wood.elasticModulus *= static_cast<float>(more);
    SwayingTree changed = tree;
    changed.species = &other;
    addStiffnessPowers(models, jointsOf(changed), little, &SizePowers::modulus);
    other = *tree.species;
    other.wood.anchorage *= static_cast<float>(more);
    addStiffnessPowers(models, jointsOf(changed), little, &SizePowers::roots);
    for (ModalModel& model : models) // what is stiff neither by its wood nor by its roots
        for (ModalModel::Mode& mode : model.modes)
            mode.stiffness.support = 1.0f - mode.stiffness.modulus - mode.stiffness.roots;
    addPowers(models, withBranches(tree, more), little, &SizePowers::branches);
    addPowers(models, withWidth(tree, static_cast<float>(more)), little, &SizePowers::width);
    changed = tree;
    changed.leaves *= static_cast<float>(1.0 / more);
    addPowers(models, jointsOf(changed), -little, &SizePowers::leaves);
}

/// How heavy for its stiffness a tree of its form is: weight times length over what its wood can hold.
float supportOf(const TreeScale& scale) {
    return std::log(scale.axes.z) - 2.0f * std::log(girthOver(scale));
}

} // namespace

ArchetypeRung nearestRung(const SwayingTree& tree) {
    return {tree.model,
            tree.species,
            steps(std::log(tree.scale.axes.z), heightStep),
            steps(supportOf(tree.scale), supportStep),
            steps(std::log(widthOver(tree.scale)), widthStep),
            steps(tree.leaves, leavesStep)};
}

SwayingTree treeOn(const ArchetypeRung& rung) {
    SwayingTree tree{rung.model, rung.species, {}, leavesStep * static_cast<float>(rung.leaves)};
    tree.scale.axes.z = std::exp(heightStep * static_cast<float>(rung.height));
    const float girth =
        0.5f * (heightStep * static_cast<float>(rung.height) -
                supportStep * static_cast<float>(rung.support)); // of its logarithm, over height
    tree.scale.radius = tree.scale.axes.z * std::exp(girth);
    tree.scale.axes.x = tree.scale.axes.y =
        tree.scale.axes.z * std::exp(widthStep * static_cast<float>(rung.width));
    tree.scale.leaf = std::cbrt(tree.scale.axes.x * tree.scale.axes.y * tree.scale.axes.z);
    return tree;
}

Archetype::Archetype(const SwayingTree& tree)
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

TreeFactors Archetype::factors(const SwayingTree& tree, float heading) const {
    const float l = tree.scale.axes.z / _scale.axes.z, r = tree.scale.radius / _scale.radius;
    TreeFactors f;
    f.cosine = std::cos(heading);
    f.sine = std::sin(heading);
    f.length = l;
    f.pace = r * r / (l * l * l * l);
    const float leaves = leafArea(*tree.model, tree.scale, *tree.species, tree.leaves);
    const SizePowers logs = growthOf(tree, leaves);
    f.logs.modulus = logs.modulus - _logs.modulus;
    f.logs.branches = logs.branches - _logs.branches;
    f.logs.width = logs.width - _logs.width;
    f.logs.support = std::log(l * l * l / (r * r)); // weight times length over stiffness of wood,
    f.logs.roots = std::log(l * l / (r * r));       // and weight over it
    f.logs.leaves = leaves > 0.0f && _leafArea > 0.0f ? logs.leaves - _logs.leaves : 0.0f;
    f.stillDrag = _leafArea > 0.0f ? leaves / _leafArea : 0.0f;
    f.leafDrag = tree.species->wood.crownDrag > 0.0f && _leaves > 0.0f
                     ? l * tree.scale.axes.x / _scale.axes.x * tree.leaves / _leaves // its outline
                     : f.stillDrag;
    return f;
}

std::shared_ptr<const Archetype> sharedArchetype(const SwayingTree& tree) {
    static SharedConstants<std::pair<std::uint64_t, std::string>, Archetype> archetypes;
    if (tree.model->identity == 0)
        return std::make_shared<const Archetype>(tree);
    const glm::vec3& axes = tree.scale.axes;
    std::string form;
    for (const float number : {axes.x, axes.y, axes.z, tree.scale.radius, tree.scale.leaf, tree.leaves})
        form.append(reinterpret_cast<const char*>(&number), sizeof number);
    addFieldBytes(tree.species->wood, form);
    addFieldBytes(tree.species->branch, form);
    return archetypes.get({tree.model->identity, form},
                          [&] { return std::make_shared<const Archetype>(tree); });
}

} // namespace osgTreeWind
