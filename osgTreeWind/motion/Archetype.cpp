// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/Archetype.h>

#include <osgTreeWind/motion/JointTree.h>
#include <osgTreeWind/motion/UnitLoads.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

// Steps between rungs: of logarithms, and of the leaves' share.
constexpr float heightStep = 0.5f, girthStep = 0.5f, widthStep = 0.2f, leavesStep = 0.25f;

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

/// The logarithms of a tree's sizes over another's.
SizePowers sizesOver(const SwayingTree& tree, const SwayingTree& other) {
    SizePowers logs;
    logs.height = std::log(tree.scale.axes.z / other.scale.axes.z);
    logs.girth = std::log(girthOver(tree.scale) / girthOver(other.scale));
    logs.width = std::log(widthOver(tree.scale) / widthOver(other.scale));
    logs.leaves = tree.leaves > 0.0f && other.leaves > 0.0f ? std::log(tree.leaves / other.leaves) : 0.0f;
    return logs;
}

/// Adds the powers by which the modes follow one size: what is left on `other`, e^little as large, when
/// scaling is taken out.
void addPowers(std::vector<ModalShape>& shapes, const SwayingTree& tree, const SwayingTree& other,
               float little, float SizePowers::*size) {
    const double l = other.scale.axes.z / tree.scale.axes.z, r = other.scale.radius / tree.scale.radius;
    const ModalRatios ratios = modalRatios(shapes.front(), jointsOf(other));
    for (ModalShape& shape : shapes)
        for (std::size_t k = 0; k < shape.modes.size(); ++k) {
            ModalShape::Mode& mode = shape.modes[k];
            mode.stiffness.*size =
                static_cast<float>(std::log(ratios.stiffness[k] * l / std::pow(r, 4.0))) / little;
            mode.mass.*size = static_cast<float>(std::log(ratios.mass[k] / (r * r * l * l * l))) / little;
        }
}

void addPowers(std::vector<ModalShape>& shapes, const SwayingTree& tree) {
    constexpr float little = 0.1f;
    const float more = std::exp(little), less = std::exp(-little);
    SwayingTree other = tree;
    other.scale.axes *= more;
    other.scale.radius *= more;
    addPowers(shapes, tree, other, little, &SizePowers::height);
    other = tree;
    other.scale.radius *= more;
    addPowers(shapes, tree, other, little, &SizePowers::girth);
    other = tree;
    other.scale.axes.x *= more;
    other.scale.axes.y *= more;
    addPowers(shapes, tree, other, little, &SizePowers::width);
    other = tree;
    other.leaves *= less;
    addPowers(shapes, tree, other, -little, &SizePowers::leaves);
}

std::vector<std::size_t> nearestPatches(const ModalShape& shape, const ModalShape& other) {
    std::vector<std::size_t> nearest;
    for (const ModalShape::Patch& patch : shape.patches) {
        const auto distance = [&](const ModalShape::Patch& o) { return glm::distance(patch.place, o.place); };
        nearest.push_back(static_cast<std::size_t>(
            std::min_element(other.patches.begin(), other.patches.end(),
                             [&](const auto& a, const auto& b) { return distance(a) < distance(b); }) -
            other.patches.begin()));
    }
    return nearest;
}

} // namespace

ArchetypeRung nearestRung(const SwayingTree& tree) {
    return {tree.model,
            tree.species,
            steps(std::log(tree.scale.axes.z), heightStep),
            steps(std::log(girthOver(tree.scale)), girthStep),
            steps(std::log(widthOver(tree.scale)), widthStep),
            steps(tree.leaves, leavesStep)};
}

SwayingTree treeOn(const ArchetypeRung& rung) {
    SwayingTree tree{rung.model, rung.species, {}, leavesStep * static_cast<float>(rung.leaves)};
    tree.scale.axes.z = std::exp(heightStep * static_cast<float>(rung.height));
    tree.scale.radius = tree.scale.axes.z * std::exp(girthStep * static_cast<float>(rung.girth));
    tree.scale.axes.x = tree.scale.axes.y =
        tree.scale.axes.z * std::exp(widthStep * static_cast<float>(rung.width));
    return tree;
}

Archetype::Archetype(const SwayingTree& tree)
    : _tree(tree), _leafArea(leafArea(*tree.model, tree.scale, *tree.species, tree.leaves)) {
    const WoodParameters& wood = tree.species->wood;
    const ModalMaterial material{wood.dampingRatio, wood.streamlining, wood.streamlinedTo,
                                 tree.species->branch.maxAngle};
    _shapes = makeModalShapes(jointsOf(tree), material, {ModalDetail{12, 10}, ModalDetail{4, 4}});
    addPowers(_shapes, tree);
    _other[0] = nearestPatches(_shapes[0], _shapes[1]);
    _other[1] = nearestPatches(_shapes[1], _shapes[0]);
}

TreeFactors Archetype::factors(const SwayingTree& tree, float heading) const {
    const float l = tree.scale.axes.z / _tree.scale.axes.z, r = tree.scale.radius / _tree.scale.radius;
    TreeFactors f;
    f.cosine = std::cos(heading);
    f.sine = std::sin(heading);
    f.length = l;
    f.pace = r * r / (l * l * l * l);
    f.logs = sizesOver(tree, _tree);
    f.stillDrag =
        _leafArea > 0.0f ? leafArea(*tree.model, tree.scale, *tree.species, tree.leaves) / _leafArea : 0.0f;
    f.leafDrag = tree.species->wood.crownDrag > 0.0f && _tree.leaves > 0.0f
                     ? l * tree.scale.axes.x / _tree.scale.axes.x * tree.leaves / _tree.leaves // its outline
                     : f.stillDrag;
    return f;
}

} // namespace osgTreeWind
