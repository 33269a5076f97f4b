// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/ForestSimulation.h>

#include <osgTreeWind/model/ThesisAxes.h>
#include <osgTreeWind/motion/GrowthLaws.h>
#include <osgTreeWind/motion/LawParameters.h>
#include <osgTreeWind/motion/NoiseTime.h>
#include <osgTreeWind/motion/Rotations.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace osgTreeWind {

namespace {

std::size_t shapeCount(const Species& species) {
    return static_cast<std::size_t>(std::clamp(species.shapes, 1, 64));
}

/// v turned counter-clockwise about the vertical.
glm::vec3 turnHeading(const glm::vec3& v, float sine, float cosine) {
    return {cosine * v.x - sine * v.y, sine * v.x + cosine * v.y, v.z};
}

} // namespace

ForestSimulation::ForestSimulation(ForestDescription description, const std::function<void()>& placed)
    : _description(std::move(description)), _wind(_description.wind) {
    const std::size_t speciesCount = _description.species.size();
    auto& placements = _description.trees;
    placements.erase(std::remove_if(placements.begin(), placements.end(),
                                    [=](const TreePlacement& p) { return p.species >= speciesCount; }),
                     placements.end());

    std::vector<std::size_t> firstModel;
    for (const Species& species : _description.species) {
        firstModel.push_back(_models.size());
        for (std::size_t shape = 0; shape < shapeCount(species); ++shape)
            _models.push_back(makeTreeModel(species.tree, static_cast<std::uint32_t>(shape)));
    }
    std::size_t units = 0, leaves = 0;
    _trees.reserve(placements.size());
    for (const TreePlacement& placement : placements) {
        Tree tree;
        tree.species = placement.species;
        tree.model =
            firstModel[tree.species] + placement.seed % shapeCount(_description.species[tree.species]);
        tree.scale =
            fitTree(_models[tree.model],
                    withCrown(placement.size, _description.species[tree.species].crown, placement.openGrown));
        tree.position = glm::vec3(placement.position - _description.origin);
        tree.heading = placement.heading;
        tree.leaves = placement.leaves;
        tree.firstUnit = units;
        tree.firstLeaf = leaves;
        units += _models[tree.model].skeleton.units.size();
        leaves += _models[tree.model].leaves.size();
        _trees.push_back(tree);
    }
    for (const Tree& tree : _trees) {
        prepareUnits(tree);
        if (placed)
            placed();
    }
    _windSamples.resize(units);
    _windTexels.resize(2 * units);
    _branchStates.resize(units);
    _rotations.resize(units);
    _poses.resize(units);
    _leafStates.resize(leaves);
    reset();
}

void ForestSimulation::prepareUnits(const Tree& tree) {
    const TreeModel& model = _models[tree.model];
    const Species& species = _description.species[tree.species];
    const float sine = std::sin(tree.heading), cosine = std::cos(tree.heading);
    for (const BranchUnit& unit : model.skeleton.units)
        _windPlaces.emplace_back(tree.position + turnHeading(tree.scale.axes * unit.base, sine, cosine),
                                 tree.position.z);
    if (_description.law == MotionLaw::Damped) {
        for (const DampedParameters& p : makeDampedParameters(model, tree.scale, species, tree.leaves)) {
            _windPlaces[_dampedBranches.size()].position.z = tree.position.z + p.windHeight;
            _dampedBranches.push_back(exaggerated(p, _description.gain));
        }
    } else {
        for (const BranchUnit& unit : model.skeleton.units)
            _branches.push_back(makeBranchParameters(unit, tree.scale, species));
    }
}

void ForestSimulation::reset() {
    std::fill(_windSamples.begin(), _windSamples.end(), glm::vec3(0.0f));
    std::fill(_windTexels.begin(), _windTexels.end(), glm::vec4(0.0f));
    std::fill(_branchStates.begin(), _branchStates.end(), glm::vec4(0.0f));
    std::fill(_leafStates.begin(), _leafStates.end(), glm::vec4(0.0f));
    std::fill(_rotations.begin(), _rotations.end(), glm::quat(1.0f, 0.0f, 0.0f, 0.0f));
    std::fill(_poses.begin(), _poses.end(), UnitPose());
    _time.reset();
}

void ForestSimulation::setWind(WindFieldPtr wind) {
    const std::lock_guard<std::mutex> lock(_windMutex);
    _wind.swap(wind); // the old field goes when the parameter does, after the lock
}

WindFieldPtr ForestSimulation::wind() const {
    const std::lock_guard<std::mutex> lock(_windMutex);
    return _wind;
}

std::size_t ForestSimulation::endOfUnits(const Tree& tree) const {
    return tree.firstUnit + _models[tree.model].skeleton.units.size();
}

void ForestSimulation::sampleWind(double time) {
    if (const WindFieldPtr field = wind())
        field->sample(_windPlaces.data(), _windPlaces.size(), time, _windSamples.data());
    else
        std::fill(_windSamples.begin(), _windSamples.end(), glm::vec3(0.0f));
    for (const Tree& tree : _trees) {
        const float sine = std::sin(-tree.heading), cosine = std::cos(-tree.heading);
        for (std::size_t i = tree.firstUnit; i < endOfUnits(tree); ++i) {
            _windTexels[2 * i] = _windTexels[2 * i + 1];
            _windTexels[2 * i + 1] = glm::vec4(turnHeading(_windSamples[i], sine, cosine), 0.0f);
        }
    }
}

std::optional<float> ForestSimulation::beginStep(double time) {
    if (!std::isfinite(time) || time == _time)
        return {};
    const double elapsed = _time ? std::min(time - *_time, maxStep) : 0.0;
    _time = time;
    sampleWind(time); // where no step is taken, for the next one to start from
    if (elapsed <= 0.0)
        return {};
    return static_cast<float>(elapsed);
}

bool ForestSimulation::advance(double time) {
    const std::optional<float> elapsed = beginStep(time);
    if (!elapsed)
        return false;
    for (std::size_t i = 0; i < _trees.size(); ++i) {
        const Tree& tree = _trees[i];
        const std::uint32_t seed = _description.trees[i].seed;
        if (_description.law == MotionLaw::Damped)
            swingBranches(tree, *elapsed);
        else
            turnBranches(tree, seed, time);
        flutterLeaves(tree, seed, time);
        pose(tree);
    }
    return true;
}

void ForestSimulation::setBranchStates(const glm::vec4* states) {
    std::copy(states, states + _branchStates.size(), _branchStates.begin());
    for (const Tree& tree : _trees)
        pose(tree);
}

void ForestSimulation::setLeafStates(const glm::vec4* states) {
    std::copy(states, states + _leafStates.size(), _leafStates.begin());
}

void ForestSimulation::pose(const Tree& tree) {
    for (std::size_t i = tree.firstUnit; i < endOfUnits(tree); ++i)
        _rotations[i] = _description.law == MotionLaw::Damped
                            ? dampedRotation(_branchStates[i], _dampedBranches[i].direction)
                            : branchRotation(_branchStates[i]);
    composePoses(_models[tree.model].skeleton, tree.scale, _rotations.data() + tree.firstUnit,
                 _poses.data() + tree.firstUnit);
}

void ForestSimulation::turnBranches(const Tree& tree, std::uint32_t seed, double time) {
    Laws laws;
    const NoiseTime now = NoiseTime::at(time, _description.species[tree.species].branch.noiseFrequency,
                                        _description.noiseExponent);
    for (std::size_t i = tree.firstUnit; i < endOfUnits(tree); ++i) {
        glm::vec3 noise;
        for (std::uint32_t axis = 0; axis < 3; ++axis) {
            const auto unit = static_cast<std::uint32_t>(i - tree.firstUnit);
            noise[static_cast<int>(axis)] =
                laws.motionNoise(laws.noiseStream(seed, unit, axis), now.cell, now.fraction, now.gain);
        }
        const Laws::ThesisBranch branch = lawParameters(_branches[i]);
        const glm::vec3 air = toThesis(glm::vec3(_windTexels[2 * i + 1]));
        glm::vec4& state = _branchStates[i];
        state = _description.law == MotionLaw::Thesis
                    ? laws.thesisBranchStep(state, air, noise, branch)
                    : laws.thesisSmoothBranchStep(state, air, noise, branch);
    }
}

void ForestSimulation::swingBranches(const Tree& tree, float seconds) {
    Laws laws;
    for (std::size_t i = tree.firstUnit; i < endOfUnits(tree); ++i) {
        const DampedParameters& p = _dampedBranches[i];
        const glm::vec2 before = laws.windAcross(glm::vec3(_windTexels[2 * i]), p.direction);
        const glm::vec2 now = laws.windAcross(glm::vec3(_windTexels[2 * i + 1]), p.direction);
        _branchStates[i] = laws.dampedBranchStep(_branchStates[i], before, now, lawParameters(p), seconds);
    }
}

void ForestSimulation::flutterLeaves(const Tree& tree, std::uint32_t seed, double time) {
    Laws laws;
    const LeafMotion& motion = _description.species[tree.species].leaf;
    const Laws::ThesisLeaf leaf = lawParameters(motion);
    const NoiseTime now = NoiseTime::at(time, motion.noiseFrequency, _description.noiseExponent);
    const auto leaves = static_cast<std::uint32_t>(_models[tree.model].leaves.size());
    for (std::uint32_t i = 0; i < leaves; ++i) {
        const float x = laws.motionNoise(laws.noiseStream(seed, i, 3), now.cell, now.fraction, now.gain);
        const float z = laws.motionNoise(laws.noiseStream(seed, i, 4), now.cell, now.fraction, now.gain);
        glm::vec4& state = _leafStates[tree.firstLeaf + i];
        state = laws.thesisLeafStep(state, x, z, leaf);
    }
}

} // namespace osgTreeWind
