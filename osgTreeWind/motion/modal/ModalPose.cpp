// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/modal/ModalAir.h>
#include <osgTreeWind/motion/modal/ModalGroup.h>

#include <cmath>

namespace osgTreeWind {

namespace {

/// A tree by itself.
struct OneLane {
    using Number = float;
    using Laws = osgTreeWind::Laws;
    static float every(float x) { return x; }
    static float root(float x) { return std::sqrt(x); }
};

} // namespace

const Archetype& ModalMotion::archetype(std::size_t tree) const {
    return *groupOf(tree).archetype;
}

const ModalModel& ModalMotion::model(std::size_t tree) const {
    return groupOf(tree).model();
}

ModalMotion::Level ModalMotion::level(std::size_t tree) const {
    return static_cast<Level>(groupOf(tree).level);
}

TreeFactors ModalMotion::factors(std::size_t tree) const {
    return groupOf(tree).factors(_slots[tree].place);
}

const TreeFall* ModalMotion::fall(std::size_t tree) const {
    if (_falls.empty())
        return nullptr;
    const auto fall = _falls.find(static_cast<std::uint32_t>(tree));
    return fall == _falls.end() ? nullptr : &fall->second;
}

float ModalMotion::shareOfSway(std::size_t tree) const {
    const TreeFall* fall = this->fall(tree);
    return fall ? fall->sway : 1.0f;
}

void ModalMotion::poseVector(std::size_t tree, float* vector) const {
    const Group& group = groupOf(tree);
    const ModalModel& model = group.model();
    const std::size_t modes = model.modes.size(), patches = model.patches.size();
    const std::size_t place = _slots[tree].place, lane = place % Group::lanes;
    const TreeLanes* block = group.block(place / Group::lanes);
    const LaneColumn<OneLane> numbers(block, lane), wind(block + 2 * modes, lane);
    ModalAir<OneLane> air(model, block, lane, _gain);
    for (std::size_t k = 0; k < modes; ++k)
        vector[k] = numbers[k];
    const LaneFactors<OneLane>& factors = air.factors();
    const float rest = // gain l / stiffness
        factors.drive / (factors.pace * factors.grown(model.modes.front().stiffness));
    for (std::size_t p = 0; p < patches; ++p) {
        air.meet(p, wind[3 * p], wind[3 * p + 1], wind[3 * p + 2]);
        for (std::size_t c = 0; c < 3; ++c)
            vector[modes + 3 * p + c] = rest * air.brake(p) * air.past(p)[c];
    }
    if (const TreeFall* fall = this->fall(tree))
        for (std::size_t i = 0; i < model.columns(); ++i)
            vector[i] *= fall->sway;
}

/// The modes from `first` on are where the air of now holds them.
void ModalMotion::settle(std::size_t tree, std::size_t first) {
    const Group& group = groupOf(tree);
    const ModalModel& model = group.model();
    const std::size_t modes = model.modes.size(), place = _slots[tree].place;
    if (first >= modes)
        return;
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    poseVector(tree, vector);
    const LaneFactors<OneLane> factors(
        {group.block(place / Group::lanes) + group.firstFactor(), place % Group::lanes}, _gain);
    for (std::size_t k = first; k < modes; ++k) {
        float force = 0.0f;
        for (std::size_t i = 0; i < 3 * model.patches.size(); ++i)
            force += model.levers[i * modes + k] * vector[modes + i];
        const ModalModel::Mode& mode = model.modes[k];
        const float left =
            factors.leftByWeight(mode, factors.grown(mode.stiffness), factors.grown(mode.mass));
        number(tree, k) = force / (mode.pace * mode.pace * left);
    }
}

void ModalMotion::patchWinds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& model = this->model(tree);
    const float share = shareOfSway(tree);
    for (std::size_t p = 0; p < model.patches.size(); ++p) {
        const std::size_t first = 2 * model.modes.size() + 3 * p;
        winds[p] = share * glm::vec3(number(tree, first), number(tree, first + 1), number(tree, first + 2));
    }
}

void ModalMotion::angles(std::size_t tree, glm::vec2* angles) const {
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    poseVector(tree, vector);
    for (std::size_t unit = 0; unit < model(tree).joints / 2; ++unit)
        angles[unit] = unitAngles(tree, unit, vector);
}

glm::vec2 ModalMotion::unitAngles(std::size_t tree, std::size_t unit, const float* vector) const {
    const ModalModel& model = this->model(tree);
    const std::size_t columns = model.columns();
    const float* row = model.poses.data() + 2 * unit * columns;
    glm::vec2 angles;
    for (glm::length_t axis = 0; axis < 2; ++axis, row += columns) {
        float angle = 0.0f; // a sum of its own stays in a register
        for (std::size_t i = 0; i < columns; ++i)
            angle += row[i] * vector[i];
        angles[axis] = Laws().bounded(angle, model.maxAngle);
    }
    return angles;
}

std::vector<float> ModalMotion::amplitudes(std::size_t tree) const {
    std::vector<float> result(this->model(tree).modes.size());
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = number(tree, k);
    return result;
}

void ModalMotion::winds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& model = this->model(tree);
    const TreeFactors f = factors(tree);
    glm::vec3 met[ModalDetail::maxPatches];
    patchWinds(tree, met);
    for (std::size_t unit = 0; unit < model.patchOfLink.size(); ++unit)
        winds[unit] = turnHeading(met[model.patchOfLink[unit]], f.sine, f.cosine);
}

std::size_t ModalMotion::stateBytes() const {
    std::size_t bytes = _slots.capacity() * sizeof(Slot) + _places.capacity() * sizeof(Place) +
                        _leans.capacity() * sizeof(glm::vec2) + _free.capacity() * sizeof(std::uint32_t);
    for (const Group& group : _groups)
        bytes += group.numbers.capacity() * sizeof(TreeLanes) +
                 group.trees.capacity() * sizeof(std::uint32_t) + group.waiting.capacity() * sizeof(float);
    return bytes;
}

std::size_t ModalMotion::treeBytes(Level level) {
    const ModalDetail& detail = Archetype::details[static_cast<std::size_t>(level)];
    return sizeof(Slot) + sizeof(Place) + sizeof(glm::vec2) + sizeof(std::uint32_t) +
           treeFloats(detail.modes, detail.patches) * sizeof(float);
}

std::size_t ModalMotion::archetypeBytes() const {
    std::size_t bytes = 0;
    for (const auto& archetype : _archetypes)
        for (std::size_t level = 0; level < Archetype::levels; ++level) {
            const ModalModel& model = archetype->model(level);
            bytes += sizeof(float) * (model.poses.size() + model.levers.size() + model.brakes.size()) +
                     sizeof(ModalModel::Mode) * model.modes.size() +
                     sizeof(ModalModel::Patch) * model.patches.size();
        }
    return bytes;
}

} // namespace osgTreeWind
