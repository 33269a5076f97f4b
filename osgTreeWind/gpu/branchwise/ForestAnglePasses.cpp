// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/ForestAnglePasses.h>

#include <osgTreeWind/motion/branchwise/ThesisParameters.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>

#include <osgUtil/CullVisitor>

#include <cstring>

namespace osgTreeWind {

namespace {

// branch_angles.frag and leaf_angles.frag construct these structs from the same number of floats.
static_assert(sizeof(Laws::ThesisBranch) == 5 * sizeof(float));
static_assert(sizeof(Laws::ThesisLeaf) == 6 * sizeof(float));

/// Appends a struct of floats as `count` texels, padded with zeros.
template <std::size_t count, typename Part>
void append(std::vector<glm::vec4>& texels, const Part& part) {
    static_assert(sizeof(Part) <= count * sizeof(glm::vec4));
    texels.resize(texels.size() + count, glm::vec4(0.0f));
    std::memcpy(&texels[texels.size() - count], &part, sizeof(Part));
}

/// Splits 32 bits into two floats of 16 bits each, which are exact.
glm::vec2 halves(std::uint32_t number) {
    return {static_cast<float>(number & 0xffffu), static_cast<float>(number >> 16u)};
}

glm::vec4 texelOf(const NoiseTime& now) {
    return {halves(now.cell), now.fraction, now.gain};
}

/// Input of the noise of a part of a tree: species, seed in two halves, index.
glm::vec4 noiseSource(const PlacedTree& tree, std::size_t index) {
    return {static_cast<float>(tree.species), halves(tree.seed), static_cast<float>(index)};
}

/// Three texels per unit: two with Laws::ThesisBranch, then noiseSource().
std::vector<glm::vec4> branchTexels(const PlacedForest& forest, const BranchwiseMotion& branches) {
    std::vector<glm::vec4> texels;
    texels.reserve(3 * forest.units);
    for (const PlacedTree& tree : forest.trees)
        for (std::size_t unit = 0; unit < forest.unitCount(tree); ++unit) {
            append<2>(texels, branches.thesisBranches()[tree.firstUnit + unit]);
            texels.push_back(noiseSource(tree, unit));
        }
    return texels;
}

/// One texel per leaf cluster: noiseSource().
std::vector<glm::vec4> leafTexels(const PlacedForest& forest) {
    std::vector<glm::vec4> texels;
    texels.reserve(forest.leaves);
    for (const PlacedTree& tree : forest.trees)
        for (std::size_t leaf = 0; leaf < forest.leafCount(tree); ++leaf)
            texels.push_back(noiseSource(tree, leaf));
    return texels;
}

/// Four texels per species: NoiseTime of branches and of leaves (cell in two halves, fraction, gain), then
/// Laws::ThesisLeaf. @param time seconds.
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

ForestAnglePasses::ForestAnglePasses(const BranchwiseMotion& motion)
    : _node(new osg::Group), _branches("branchwise/branch_angles", motion.states()),
      _leaves("branchwise/leaf_angles", motion.leafStates()), _wind("wind", motion.forest().units),
      _branchParameters("branch parameters", 3 * motion.forest().units),
      _leafParameters("leaf parameters", motion.forest().leaves),
      _species("species", speciesTexels(motion.forest().description(), 0.0).size()) {
    _branchParameters.fill(branchTexels(motion.forest(), motion));
    _leafParameters.fill(leafTexels(motion.forest()));

    bindDataTexture(_branches.inputs(), "wind", 1, _wind.texture());
    bindDataTexture(_branches.inputs(), "branchParameters", 2, _branchParameters.texture());
    bindDataTexture(_branches.inputs(), "speciesTexels", 3, _species.texture());
    _branches.inputs().addUniform(
        new osg::Uniform("motionLaw", static_cast<int>(motion.forest().description().law)));
    bindDataTexture(_leaves.inputs(), "leafParameters", 1, _leafParameters.texture());
    bindDataTexture(_leaves.inputs(), "speciesTexels", 2, _species.texture());

    _node->setName("angle passes");
    _node->addChild(_branches.node());
    _node->addChild(_leaves.node());
}

void ForestAnglePasses::cull(osg::NodeVisitor& visitor) {
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

void ForestAnglePasses::step(const BranchwiseMotion& motion, double time) {
    _wind.fill(motion.windTexels());
    _species.fill(speciesTexels(motion.forest().description(), time));
    _branches.step();
    _leaves.step();
}

void ForestAnglePasses::hold() {
    _branches.hold();
    _leaves.hold();
}

bool ForestAnglePasses::readBack(BranchwiseMotion& motion) {
    if (_leaves.readBack(_states))
        motion.setLeafStates(_states);
    if (!_branches.readBack(_states))
        return false;
    motion.setStates(_states);
    return true;
}

} // namespace osgTreeWind
