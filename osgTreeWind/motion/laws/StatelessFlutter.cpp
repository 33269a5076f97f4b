// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/StatelessFlutter.h>

#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/species/SpeciesKeys.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {
namespace {

constexpr double frequencyRatios[] = {0.7071067811865476, 1.0,
                                      1.618033988749895}; // relative to the noise frequency

float wrapped(double periods) {
    const float fraction = static_cast<float>(periods - std::floor(periods));
    return fraction < 1.0f ? fraction : 0.0f; // catches rounding up to 1, and NaN
}

} // namespace

float treeRandom(std::uint32_t seed) {
    return Laws().unitInterval(Laws().scrambleBits(seed));
}

glm::vec3 flutterPhases(double time, const LeafMotion& motion) {
    const double periods = time * static_cast<double>(motion.noiseFrequency);
    return {wrapped(frequencyRatios[0] * periods), wrapped(frequencyRatios[1] * periods),
            wrapped(frequencyRatios[2] * periods)};
}

glm::vec4 flutterLimits(const LeafMotion& given) {
    Laws laws;
    const LeafMotion motion = clampedKeys(given);
    return {motion.factor * laws.angleLimit(motion.maxAngleX),
            motion.factor * laws.angleLimit(motion.maxAngleZ), motion.maxRotation, motion.linkedFactor};
}

glm::vec2 leafTremble(const LeafMotion& given) {
    // The rms speed of leaves of size D in a wind u is D u^2 / (740^2 nu).
    constexpr float airViscosity = 1.5e-5f; // kinematic, m^2/s
    constexpr float speedPerSize = 1.0f / (740.0f * 740.0f * airViscosity);
    constexpr float cardSpeed = 17.0f; // rms of trembleWave(), averaged over a card, over the noise frequency
    const LeafMotion motion = clampedKeys(given);
    const float stiffness = cardSpeed * motion.noiseFrequency / speedPerSize;
    return {motion.size, std::max(stiffness, 1e-3f) / std::max(motion.tremble, 1e-6f)};
}

void StatelessFlutter::run(glm::vec4* states) const {
    Laws laws;
    for (std::size_t i = 0; i < leaves.size; ++i) {
        const auto unit = static_cast<std::size_t>(leaves[i].unit);
        const auto leaf = static_cast<float>(i);
        const float gust =
            laws.pullOfGusts(axes * leaves[i].anchor, glm::vec3(pulls[unit]), phases, own, leaf);
        const float speed = glm::length(winds[unit]);
        states[i] = glm::vec4(laws.leafFlutter(speed, gust, phases, own, leaf, limits), gust);
    }
}

} // namespace osgTreeWind
