// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/AnglePrePass.h>

#include <osgTreeWind/motion/branchwise/ThesisParts.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>

#include <osgUtil/CullVisitor>

#include <cstring>

namespace osgTreeWind {

namespace {

// The constructors in branch_angles.frag and leaf_angles.frag take as many.
static_assert(sizeof(Laws::ThesisBranch) == 5 * sizeof(float));
static_assert(sizeof(Laws::ThesisLeaf) == 6 * sizeof(float));

/// A struct of floats of a law as that many texels, filled up with 0.
template <std::size_t count, typename Part>
void append(std::vector<glm::vec4>& texels, const Part& part) {
    static_assert(sizeof(Part) <= count * sizeof(glm::vec4));
    texels.resize(texels.size() + count, glm::vec4(0.0f));
    std::memcpy(&texels[texels.size() - count], &part, sizeof(Part));
}

/// 32 bits as two floats that hold 16 bits each exactly.
glm::vec2 halves(std::uint32_t number) {
    return {static_cast<float>(number & 0xffffu), static_cast<float>(number >> 16u)};
}

glm::vec4 texelOf(const NoiseTime& now) {
    return {halves(now.cell), now.fraction, now.gain};
}

/// Where the noise of a part of a tree comes from.
glm::vec4 noiseSource(const PlacedTree& tree, std::size_t index) {
    return {static_cast<float>(tree.species), halves(tree.seed), static_cast<float>(index)};
}

/// Three texels a unit: what it is to the laws; in the last one the species, the seed of its tree in two
/// halves, and its index in the tree.
std::vector<glm::vec4> branchTexels(const PlacedForest& forest, const BranchwiseMotion& branches) {
    std::vector<glm::vec4> texels;
    texels.reserve(3 * forest.units);
    for (const PlacedTree& tree : forest.trees)
        for (std::size_t unit = 0; unit < forest.unitsOf(tree); ++unit) {
            append<2>(texels, branches.thesisBranches()[tree.firstUnit + unit]);
            texels.push_back(noiseSource(tree, unit));
        }
    return texels;
}

/// One texel a leaf cluster: species, seed of its tree in two halves, index in its tree.
std::vector<glm::vec4> leafTexels(const PlacedForest& forest) {
    std::vector<glm::vec4> texels;
    texels.reserve(forest.leaves);
    for (const PlacedTree& tree : forest.trees)
        for (std::size_t leaf = 0; leaf < forest.leavesOf(tree); ++leaf)
            texels.push_back(noiseSource(tree, leaf));
    return texels;
}

/// Four texels a species: NoiseTime of branches and of leaves (cell in two halves, fraction, gain), leaf
/// motion. @param time seconds.
std::vector<glm::vec4> speciesTexels(const ForestDescription& description, double time) {
    const std::optional<float> exponent = description.noiseExponent;
    std::vector<glm::vec4> texels;
    for (const Species& species : description.species) {
        texels.push_back(texelOf(NoiseTime::at(time, species.branch.noiseFrequency, exponent)));
        texels.push_back(texelOf(NoiseTime::at(time, species.leaf.noiseFrequency, exponent)));
        append<2>(texels, makeThesisLeaf(species.leaf));
    }
    return texels;
}

} // namespace

AnglePrePass::AnglePrePass(const BranchwiseMotion& motion)
    : _node(new osg::Group), _branches("branchwise/branch_angles", motion.states()),
      _leaves("branchwise/leaf_angles", motion.leafStates()), _wind("wind", motion.forest().units),
      _branchParameters("branch parameters", 3 * motion.forest().units),
      _leafParameters("leaf parameters", motion.forest().leaves),
      _species("species", speciesTexels(motion.forest().description(), 0.0).size()) {
    _branchParameters.fill(branchTexels(motion.forest(), motion));
    _leafParameters.fill(leafTexels(motion.forest()));

    bindData(_branches.inputs(), "wind", 1, _wind.texture());
    bindData(_branches.inputs(), "branchParameters", 2, _branchParameters.texture());
    bindData(_branches.inputs(), "speciesTexels", 3, _species.texture());
    _branches.inputs().addUniform(
        new osg::Uniform("motionLaw", static_cast<int>(motion.forest().description().law)));
    bindData(_leaves.inputs(), "leafParameters", 1, _leafParameters.texture());
    bindData(_leaves.inputs(), "speciesTexels", 2, _species.texture());

    _node->setName("angle passes");
    _node->addChild(_branches.node());
    _node->addChild(_leaves.node());
}

void AnglePrePass::cull(osg::NodeVisitor& visitor) {
    if (const auto* cull = visitor.asCullVisitor(); cull && cull->getFrameStamp()) {
        const unsigned context = cull->getState() ? cull->getState()->getContextID() : 0;
        const unsigned frame = cull->getFrameStamp()->getFrameNumber();
        const std::lock_guard<std::mutex> lock(_mutex);
        const auto [last, isNew] = _lastFrame.try_emplace(context, frame);
        if (!isNew && last->second == frame)
            return;
        last->second = frame;
    }
    _node->accept(visitor);
}

void AnglePrePass::step(const BranchwiseMotion& motion, double time) {
    _wind.fill(motion.windTexels());
    _species.fill(speciesTexels(motion.forest().description(), time));
    _branches.step();
    _leaves.step();
}

void AnglePrePass::hold() {
    _branches.hold();
    _leaves.hold();
}

bool AnglePrePass::readBack(BranchwiseMotion& motion) {
    if (_leaves.take(_states))
        motion.setLeafStates(_states);
    if (!_branches.take(_states))
        return false;
    motion.setStates(_states);
    return true;
}

} // namespace osgTreeWind
