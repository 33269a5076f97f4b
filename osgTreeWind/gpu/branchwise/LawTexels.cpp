// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/branchwise/LawTexels.h>

#include <osgTreeWind/motion/branchwise/ThesisParts.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>

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

} // namespace

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

std::vector<glm::vec4> leafTexels(const PlacedForest& forest) {
    std::vector<glm::vec4> texels;
    texels.reserve(forest.leaves);
    for (const PlacedTree& tree : forest.trees)
        for (std::size_t leaf = 0; leaf < forest.leavesOf(tree); ++leaf)
            texels.push_back(noiseSource(tree, leaf));
    return texels;
}

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

} // namespace osgTreeWind
