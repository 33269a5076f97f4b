// SPDX-License-Identifier: MIT
#include <osgTreeWind/gpu/LawTexels.h>

#include <osgTreeWind/motion/NoiseTime.h>

namespace osgTreeWind {
namespace {

/// 32 bits as two floats that hold 16 bits each exactly.
glm::vec2 halves(std::uint32_t number) {
    return {static_cast<float>(number & 0xffffu), static_cast<float>(number >> 16u)};
}

glm::vec4 texelOf(const NoiseTime& now) {
    return {halves(now.cell), now.fraction, now.gain};
}

} // namespace

std::vector<glm::vec4> branchTexels(const PlacedForest& forest, const BranchwiseMotion& branches) {
    std::vector<glm::vec4> texels;
    texels.reserve(3 * forest.units);
    for (const DampedParameters& p : branches.dampedBranches()) {
        texels.emplace_back(p.stiffness, p.inertia, p.damping, p.drag);
        texels.emplace_back(p.lever, p.maxAngle, p.streamlining, p.streamlinedTo);
        texels.emplace_back(p.direction, 0.0f);
    }
    if (branches.thesisBranches().empty())
        return texels;
    for (const PlacedTree& tree : forest.trees) {
        const glm::vec2 seed = halves(tree.seed);
        for (std::size_t unit = 0; unit < forest.unitsOf(tree); ++unit) {
            const BranchParameters& p = branches.thesisBranches()[tree.firstUnit + unit];
            texels.emplace_back(p.spring, p.length, p.maxAngle, p.partialSteps);
            texels.emplace_back(p.levelLoad, static_cast<float>(tree.species), seed.x, seed.y);
            texels.emplace_back(static_cast<float>(unit), 0.0f, 0.0f, 0.0f);
        }
    }
    return texels;
}

std::vector<glm::vec4> leafTexels(const PlacedForest& forest) {
    std::vector<glm::vec4> texels;
    texels.reserve(forest.leaves);
    for (const PlacedTree& tree : forest.trees) {
        const glm::vec2 seed = halves(tree.seed);
        for (std::size_t leaf = 0; leaf < forest.leavesOf(tree); ++leaf)
            texels.emplace_back(static_cast<float>(tree.species), seed.x, seed.y, static_cast<float>(leaf));
    }
    return texels;
}

std::vector<glm::vec4> speciesTexels(const ForestDescription& description, double time) {
    const std::optional<float> exponent = description.noiseExponent;
    std::vector<glm::vec4> texels;
    for (const Species& species : description.species) {
        const LeafMotion& leaf = species.leaf;
        texels.push_back(texelOf(NoiseTime::at(time, species.branch.noiseFrequency, exponent)));
        texels.push_back(texelOf(NoiseTime::at(time, leaf.noiseFrequency, exponent)));
        texels.emplace_back(leaf.maxAngleX, leaf.maxAngleZ, leaf.maxRotation, leaf.partialSteps);
        texels.emplace_back(leaf.factor, leaf.linkedFactor, 0.0f, 0.0f);
    }
    return texels;
}

} // namespace osgTreeWind
