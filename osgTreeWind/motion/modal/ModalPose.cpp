// SPDX-License-Identifier: MIT
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/modal/ModalGroup.h>

#include <cmath>

namespace osgTreeWind {

const Archetype& ModalMotion::archetype(std::size_t tree) const {
    return *groupOf(tree).archetype;
}

const ModalModel& ModalMotion::shape(std::size_t tree) const {
    return groupOf(tree).shape();
}

ModalMotion::Level ModalMotion::level(std::size_t tree) const {
    return static_cast<Level>(groupOf(tree).level);
}

TreeFactors ModalMotion::factors(std::size_t tree) const {
    return groupOf(tree).factors(_slots[tree].place);
}

void ModalMotion::poseVector(std::size_t tree, float* vector) const {
    const ModalModel& shape = this->shape(tree);
    const std::size_t modes = shape.modes.size(), patches = shape.patches.size();
    const TreeFactors f = factors(tree);
    Laws laws;
    for (std::size_t k = 0; k < modes; ++k)
        vector[k] = number(tree, k);
    const SizePowers& stiffness = shape.modes.front().stiffness;
    const float reach = _gain > 0.0f ? f.length / _gain : 0.0f;
    const float wooden = std::sqrt(f.pace) * f.length * f.length * f.length;
    const float rest =
        _gain / (wooden * wooden * f.pace) / // gain l / stiffness
        laws.nearExponential(stiffness.modulus * f.logs.modulus + stiffness.branches * f.logs.branches +
                             stiffness.width * f.logs.width + stiffness.leaves * f.logs.leaves);
    for (std::size_t p = 0; p < patches; ++p) {
        const ModalModel::Patch& patch = shape.patches[p];
        glm::vec3 air, own(0.0f);
        for (std::size_t c = 0; c < 3; ++c) {
            const auto axis = static_cast<glm::length_t>(c);
            air[axis] = number(tree, 2 * modes + 3 * p + c);
            for (std::size_t k = 0; k < modes; ++k)
                own[axis] += reach * shape.levers[(3 * p + c) * modes + k] * number(tree, modes + k);
        }
        const float wood = patch.woodDrag * wooden;
        const float drag = (wood + patch.leafDrag * f.leafDrag) *
                           laws.streamlinedShare(patch.streamlining, shape.streamlinedTo, glm::length(air));
        const glm::vec3 relative = air - own;
        const float brake = laws.airBrake(drag, wood + patch.stillDrag * f.stillDrag, glm::dot(air, air),
                                          glm::dot(own, own), glm::dot(relative, relative));
        for (std::size_t c = 0; c < 3; ++c)
            vector[modes + 3 * p + c] = rest * brake * relative[static_cast<glm::length_t>(c)];
    }
}

void ModalMotion::patchSpeeds(std::size_t tree, float* speeds) const {
    const ModalModel& shape = this->shape(tree);
    for (std::size_t p = 0; p < shape.patches.size(); ++p) {
        const std::size_t first = 2 * shape.modes.size() + 3 * p;
        speeds[p] =
            glm::length(glm::vec3(number(tree, first), number(tree, first + 1), number(tree, first + 2)));
    }
}

void ModalMotion::angles(std::size_t tree, glm::vec2* angles) const {
    float vector[ModalDetail::maxModes + 3 * ModalDetail::maxPatches];
    poseVector(tree, vector);
    for (std::size_t unit = 0; unit < shape(tree).joints / 2; ++unit)
        angles[unit] = unitAngles(tree, unit, vector);
}

glm::vec2 ModalMotion::unitAngles(std::size_t tree, std::size_t unit, const float* vector) const {
    const ModalModel& shape = this->shape(tree);
    const float* row = shape.poses.data() + 2 * unit * shape.columns();
    glm::vec2 sums(0.0f);
    for (glm::length_t axis = 0; axis < 2; ++axis)
        for (std::size_t i = 0; i < shape.columns(); ++i)
            sums[axis] += *row++ * vector[i];
    Laws laws;
    return {laws.bounded(sums.x, shape.maxAngle), laws.bounded(sums.y, shape.maxAngle)};
}

std::vector<float> ModalMotion::amplitudes(std::size_t tree) const {
    std::vector<float> result(this->shape(tree).modes.size());
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = number(tree, k);
    return result;
}

void ModalMotion::winds(std::size_t tree, glm::vec3* winds) const {
    const ModalModel& shape = this->shape(tree);
    const TreeFactors f = factors(tree);
    for (std::size_t unit = 0; unit < shape.patchOfLink.size(); ++unit) {
        const std::size_t first = 2 * shape.modes.size() + 3 * shape.patchOfLink[unit];
        const float x = number(tree, first), y = number(tree, first + 1);
        winds[unit] = {f.cosine * x - f.sine * y, f.sine * x + f.cosine * y, number(tree, first + 2)};
    }
}

std::size_t ModalMotion::stateBytes() const {
    std::size_t bytes = _slots.capacity() * sizeof(Slot) + _places.capacity() * sizeof(Place) +
                        _leans.capacity() * sizeof(glm::vec2) + _free.capacity() * sizeof(std::uint32_t);
    for (const Group& group : _groups)
        bytes += group.numbers.capacity() * sizeof(TreeLanes) +
                 group.trees.capacity() * sizeof(std::uint32_t) + group.waiting.capacity() * sizeof(float);
    return bytes;
}

std::size_t ModalMotion::archetypeBytes() const {
    std::size_t bytes = 0;
    for (const auto& archetype : _archetypes)
        for (std::size_t level = 0; level < Archetype::levels; ++level) {
            const ModalModel& shape = archetype->shape(level);
            bytes += sizeof(float) * (shape.poses.size() + shape.levers.size() + shape.brakes.size()) +
                     sizeof(ModalModel::Mode) * shape.modes.size() +
                     sizeof(ModalModel::Patch) * shape.patches.size();
        }
    return bytes;
}

} // namespace osgTreeWind
