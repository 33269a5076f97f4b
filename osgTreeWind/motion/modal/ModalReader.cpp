// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/modal/ModalReader.h>

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/modal/ModalAir.h>

#include <cmath>

namespace osgTreeWind {

namespace {

/// A single tree.
struct OneLane {
    using Number = float;
    using Laws = osgTreeWind::Laws;
    static float every(float x) { return x; }
    static float root(float x) { return std::sqrt(x); }
};

LaneFactors<OneLane> factorsOfTree(const ModalState& state, std::size_t tree) {
    const ModalGroup& group = state.groupOf(tree);
    const std::size_t place = state.slots[tree].place;
    return {{group.block(place / ModalGroup::lanes) + group.firstFactor(), place % ModalGroup::lanes},
            state.gain};
}

} // namespace

void ModalReader::poseVector(std::size_t tree, float* vector) const {
    const ModalGroup& group = _state.groupOf(tree);
    const ModalModel& model = group.model();
    const std::size_t modes = model.modes.size(), patches = model.patches.size();
    const std::size_t place = _state.slots[tree].place, lane = place % ModalGroup::lanes;
    const TreeLanes* block = group.block(place / ModalGroup::lanes);
    const LaneColumn<OneLane> numbers(block, lane), wind(block + 2 * modes, lane);
    ModalAir<OneLane> air(model, block, lane, _state.gain);
    for (std::size_t k = 0; k < modes; ++k)
        vector[k] = numbers[k];
    const LaneFactors<OneLane>& factors = air.factors();
    const float rest = // residual flexibility: gain l / stiffness
        factors.forceScale / (factors.omegaSquare * factors.sizeFactor(model.modes.front().stiffness));
    for (std::size_t p = 0; p < patches; ++p) {
        air.setWind(p, wind[3 * p], wind[3 * p + 1], wind[3 * p + 2]);
        for (std::size_t c = 0; c < 3; ++c)
            vector[modes + 3 * p + c] = rest * air.brake(p) * air.relativeWind(p)[c];
    }
    if (const TreeFall* fall = this->fall(tree))
        for (std::size_t i = 0; i < model.columns(); ++i)
            vector[i] *= fall->sway;
}

float ModalReader::staticAmplitude(std::size_t tree, std::size_t mode, const float* vector) const {
    const ModalModel& model = this->model(tree);
    const std::size_t modes = model.modes.size();
    const LaneFactors<OneLane> factors = factorsOfTree(_state, tree);
    float force = 0.0f;
    for (std::size_t i = 0; i < 3 * model.patches.size(); ++i)
        force += model.levers[i * modes + mode] * vector[modes + i];
    const ModalModel::Mode& m = model.modes[mode];
    const float left = factors.stiffnessLeft(m, factors.sizeFactor(m.stiffness), factors.sizeFactor(m.mass));
    return force / (m.omega * m.omega * left);
}

float ModalReader::omega(std::size_t tree, std::size_t mode) const {
    const LaneFactors<OneLane> factors = factorsOfTree(_state, tree);
    const ModalModel::Mode& m = model(tree).modes[mode];
    const float stiffness = factors.sizeFactor(m.stiffness), mass = factors.sizeFactor(m.mass);
    return m.omega *
           std::sqrt(factors.omegaSquare * stiffness * factors.stiffnessLeft(m, stiffness, mass) / mass);
}

void ModalReader::patchWinds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& model = this->model(tree);
    const float share = _state.swayShare(tree);
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        const std::size_t first = 2 * model.modes.size() + 3 * p;
        winds[p] = share * glm::vec3(_state.number(tree, first), _state.number(tree, first + 1),
                                     _state.number(tree, first + 2));
    }
}

void ModalReader::angles(std::size_t tree, glm::vec2* angles, float ahead) const {
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    poseVector(tree, vector);
    const std::size_t modes = model(tree).modes.size();
    for (std::size_t k = 0; k < modes; ++k)
        vector[k] += ahead * _state.swayShare(tree) * _state.number(tree, modes + k);
    for (std::size_t unit = 0; unit < model(tree).joints / 2; ++unit)
        angles[unit] = unitAngles(tree, unit, vector);
}

glm::vec2 ModalReader::unitAngles(std::size_t tree, std::size_t unit, const float* vector) const {
    const ModalModel& model = this->model(tree);
    const std::size_t columns = model.columns();
    const float* row = model.poses.data() + 2 * unit * columns;
    glm::vec2 angles;
    for (glm::length_t axis = 0; axis < 2; ++axis, row += columns) {
        float angle = 0.0f; // a local sum stays in a register
        for (std::size_t i = 0; i < columns; ++i)
            angle += row[i] * vector[i];
        angles[axis] = Laws().bounded(angle, model.maxAngle);
    }
    return angles;
}

std::vector<float> ModalReader::amplitudes(std::size_t tree) const {
    std::vector<float> result(this->model(tree).modes.size());
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = _state.number(tree, k);
    return result;
}

void ModalReader::winds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& model = this->model(tree);
    const TreeFactors f = factors(tree);
    glm::vec3 met[ModalDetail::maxPatches];
    patchWinds(tree, met);
    for (std::size_t unit = 0; unit < model.patchOfLink.size(); ++unit)
        winds[unit] = rotateAboutZ(met[model.patchOfLink[unit]], f.sine, f.cosine);
}

} // namespace osgTreeWind
