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

std::vector<glm::vec4> branchTexels(const ForestSimulation& simulation) {
    std::vector<glm::vec4> texels;
    texels.reserve(3 * simulation.poses().size());
    for (const DampedParameters& p : simulation.dampedParameters()) {
        texels.emplace_back(p.stiffness, p.inertia, p.damping, p.drag);
        texels.emplace_back(p.lever, p.maxAngle, p.streamlining, p.streamlinedTo);
        texels.emplace_back(p.direction, 0.0f);
    }
    if (simulation.branchParameters().empty())
        return texels;
    for (std::size_t t = 0; t < simulation.trees().size(); ++t) {
        const ForestSimulation::Tree& tree = simulation.trees()[t];
        const glm::vec2 seed = halves(simulation.description().trees[t].seed);
        const std::size_t units = simulation.models()[tree.model].skeleton.units.size();
        for (std::size_t unit = 0; unit < units; ++unit) {
            const BranchParameters& p = simulation.branchParameters()[tree.firstUnit + unit];
            texels.emplace_back(p.spring, p.length, p.maxAngle, p.partialSteps);
            texels.emplace_back(p.levelLoad, static_cast<float>(tree.species), seed.x, seed.y);
            texels.emplace_back(static_cast<float>(unit), 0.0f, 0.0f, 0.0f);
        }
    }
    return texels;
}

std::vector<glm::vec4> leafTexels(const ForestSimulation& simulation) {
    std::vector<glm::vec4> texels;
    texels.reserve(simulation.leafStates().size());
    for (std::size_t t = 0; t < simulation.trees().size(); ++t) {
        const ForestSimulation::Tree& tree = simulation.trees()[t];
        const glm::vec2 seed = halves(simulation.description().trees[t].seed);
        const std::size_t leaves = simulation.models()[tree.model].leaves.size();
        for (std::size_t leaf = 0; leaf < leaves; ++leaf)
            texels.emplace_back(static_cast<float>(tree.species), seed.x, seed.y, static_cast<float>(leaf));
    }
    return texels;
}

std::vector<glm::vec4> speciesTexels(const ForestSimulation& simulation, double time) {
    const std::optional<float> exponent = simulation.description().noiseExponent;
    std::vector<glm::vec4> texels;
    for (const Species& species : simulation.description().species) {
        const LeafMotion& leaf = species.leaf;
        texels.push_back(texelOf(NoiseTime::at(time, species.branch.noiseFrequency, exponent)));
        texels.push_back(texelOf(NoiseTime::at(time, leaf.noiseFrequency, exponent)));
        texels.emplace_back(leaf.maxAngleX, leaf.maxAngleZ, leaf.maxRotation, leaf.partialSteps);
        texels.emplace_back(leaf.factor, leaf.linkedFactor, 0.0f, 0.0f);
    }
    return texels;
}

} // namespace osgTreeWind
