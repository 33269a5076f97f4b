// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/branchwise/LeafFlutter.h>

#include <osgTreeWind/motion/branchwise/ThesisParts.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>

#include <algorithm>

namespace osgTreeWind {

LeafFlutter::LeafFlutter(const PlacedForest& forest, bool wanted)
    : _forest(forest), _states(wanted ? forest.leaves : 0, glm::vec4(0.0f)) {}

void LeafFlutter::reset() {
    std::fill(_states.begin(), _states.end(), glm::vec4(0.0f));
}

void LeafFlutter::step(double time) {
    if (_states.empty())
        return;
    Laws laws;
    for (const PlacedTree& tree : _forest.trees) {
        const LeafMotion& motion = _forest.speciesOf(tree).leaf;
        const Laws::ThesisLeaf leaf = makeThesisLeaf(motion);
        const NoiseTime now = NoiseTime::at(time, motion.noiseFrequency, _forest.description().noiseExponent);
        const auto leaves = static_cast<std::uint32_t>(_forest.leavesOf(tree));
        for (std::uint32_t i = 0; i < leaves; ++i) {
            const float x =
                laws.motionNoise(laws.noiseStream(tree.seed, i, 3), now.cell, now.fraction, now.gain);
            const float z =
                laws.motionNoise(laws.noiseStream(tree.seed, i, 4), now.cell, now.fraction, now.gain);
            glm::vec4& state = _states[tree.firstLeaf + i];
            state = laws.thesisLeafStep(state, x, z, leaf);
        }
    }
}

void LeafFlutter::setStates(const std::vector<glm::vec4>& states) {
    std::copy_n(states.begin(), _states.size(), _states.begin()); // where they are: motion() points to them
}

} // namespace osgTreeWind
