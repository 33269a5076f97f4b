// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/model/ThesisAxes.h>
#include <osgTreeWind/motion/branchwise/ThesisParameters.h>
#include <osgTreeWind/motion/laws/NoiseTime.h>
#include <osgTreeWind/motion/laws/Rotations.h>
#include <osgTreeWind/motion/laws/UnitPose.h>

#include <algorithm>

namespace osgTreeWind {

BranchwiseMotion::BranchwiseMotion(const PlacedForest& forest, bool leaves,
                                   const std::function<void()>& onTreePlaced)
    : _forest(forest), _withLeaves(leaves), _winds(forest.units), _windTexels(forest.units),
      _states(forest.units), _leafStates(leaves ? forest.leaves : 0), _rotations(forest.units),
      _poses(forest.units) {
    for (const PlacedTree& tree : _forest.trees) {
        const float sine = math::sin(tree.heading), cosine = math::cos(tree.heading);
        for (const BranchUnit& unit : _forest.modelOf(tree).skeleton.units) {
            _windPlaces.emplace_back(tree.position + rotateAboutZ(tree.scale.axes * unit.base, sine, cosine),
                                     tree.position.z);
            _windPlaces.back().inCrown = true;
            _branches.push_back(makeThesisBranch(unit, tree.scale, _forest.speciesOf(tree)));
        }
        if (onTreePlaced)
            onTreePlaced();
    }
    reset();
}

void BranchwiseMotion::reset() {
    std::fill(_winds.begin(), _winds.end(), glm::vec3(0.0f));
    std::fill(_windTexels.begin(), _windTexels.end(), glm::vec4(0.0f));
    std::fill(_states.begin(), _states.end(), glm::vec4(0.0f));
    std::fill(_leafStates.begin(), _leafStates.end(), glm::vec4(0.0f));
    std::fill(_rotations.begin(), _rotations.end(), glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
    std::fill(_poses.begin(), _poses.end(), UnitPose());
}

void BranchwiseMotion::sampleWind(const WindField* wind, double time) {
    if (wind)
        wind->sample(_windPlaces.data(), _windPlaces.size(), time, _winds.data());
    else
        std::fill(_winds.begin(), _winds.end(), glm::vec3(0.0f));
    for (const PlacedTree& tree : _forest.trees) {
        const float sine = math::sin(-tree.heading), cosine = math::cos(-tree.heading);
        for (std::size_t i = tree.firstUnit; i < tree.firstUnit + _forest.unitCount(tree); ++i)
            _windTexels[i] = glm::vec4(rotateAboutZ(_winds[i], sine, cosine), 0.0f);
    }
}

void BranchwiseMotion::step(const WindField* wind, double time) {
    sampleWind(wind, time);
    for (const PlacedTree& tree : _forest.trees) {
        stepBranches(tree, time);
        composePosesOf(tree);
        if (_withLeaves)
            stepLeaves(tree, time);
    }
}

void BranchwiseMotion::setStates(const std::vector<glm::vec4>& states) {
    // Copied in place, since motion() refers to this memory.
    std::copy_n(states.begin(), _states.size(), _states.begin());
    for (const PlacedTree& tree : _forest.trees)
        composePosesOf(tree);
}

void BranchwiseMotion::setLeafStates(const std::vector<glm::vec4>& states) {
    std::copy_n(states.begin(), _leafStates.size(), _leafStates.begin());
}

TreeMotion BranchwiseMotion::motion(std::size_t slot) const {
    if (slot >= _forest.trees.size())
        return {};
    const PlacedTree& tree = _forest.trees[slot];
    const std::size_t first = tree.firstUnit, units = _forest.unitCount(tree);
    Span<glm::vec4> leaves;
    if (_withLeaves)
        leaves = {_leafStates.data() + tree.firstLeaf, _forest.leafCount(tree)};
    return {{_poses.data() + first, units},
            {_rotations.data() + first, units},
            {_states.data() + first, units},
            {_winds.data() + first, units},
            leaves,
            {}};
}

void BranchwiseMotion::stepBranches(const PlacedTree& tree, double time) {
    Laws laws;
    const NoiseTime now = NoiseTime::at(time, _forest.speciesOf(tree).branch.noiseFrequency,
                                        _forest.description().noiseExponent);
    const auto units = static_cast<std::uint32_t>(_forest.unitCount(tree));
    for (std::uint32_t unit = 0; unit < units; ++unit) {
        glm::vec3 noise;
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            noise[static_cast<int>(axis)] =
                laws.motionNoise(laws.noiseStream(tree.seed, unit, axis), now.cell, now.fraction, now.gain);
        const std::size_t i = tree.firstUnit + unit;
        const glm::vec3 air = toThesis(glm::vec3(_windTexels[i]));
        _states[i] = _forest.description().law == MotionLaw::Thesis
                         ? laws.thesisBranchStep(_states[i], air, noise, _branches[i])
                         : laws.thesisSmoothBranchStep(_states[i], air, noise, _branches[i]);
    }
}

void BranchwiseMotion::composePosesOf(const PlacedTree& tree) {
    const std::size_t first = tree.firstUnit;
    for (std::size_t i = first; i < first + _forest.unitCount(tree); ++i)
        _rotations[i] = branchRotation(_states[i]);
    composePoses(_forest.modelOf(tree).skeleton, tree.scale, _rotations.data() + first,
                 _poses.data() + first);
}

void BranchwiseMotion::stepLeaves(const PlacedTree& tree, double time) {
    Laws laws;
    const LeafMotion& motion = _forest.speciesOf(tree).leaf;
    const Laws::ThesisLeaf leaf = makeThesisLeaf(motion);
    const NoiseTime now = NoiseTime::at(time, motion.noiseFrequency, _forest.description().noiseExponent);
    const auto noise = [&](std::uint32_t i, std::uint32_t axis) {
        return laws.motionNoise(laws.noiseStream(tree.seed, i, axis), now.cell, now.fraction, now.gain);
    };
    const auto leaves = static_cast<std::uint32_t>(_forest.leafCount(tree));
    for (std::uint32_t i = 0; i < leaves; ++i) {
        glm::vec4& state = _leafStates[tree.firstLeaf + i];
        state = laws.thesisLeafStep(state, noise(i, 3), noise(i, 4), leaf);
    }
}

} // namespace osgTreeWind
