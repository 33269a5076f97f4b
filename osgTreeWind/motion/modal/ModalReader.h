// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalState.h>
#include <osgTreeWind/motion/modal/ModalTree.h>

namespace osgTreeWind {

/// Queries on trees under the law `modal`. Thread-safe as long as nothing changes the trees.
class ModalReader {
public:
    /// All tree numbers are below this; some may be those of removed trees.
    std::size_t treeCount() const { return _state.slots.size(); }
    bool holds(std::size_t tree) const {
        return tree < _state.slots.size() && _state.slots[tree].group != ModalState::Slot().group;
    }
    const Archetype& archetype(std::size_t tree) const { return *_state.groupOf(tree).archetype; }
    /// The model of the tree's archetype at its present level.
    const ModalModel& model(std::size_t tree) const { return _state.groupOf(tree).model(); }
    ModalLevel level(std::size_t tree) const { return static_cast<ModalLevel>(_state.groupOf(tree).level); }
    /// The tree's factors relative to its archetype.
    TreeFactors factors(std::size_t tree) const { return _state.factors(tree); }
    const TreeFall* fall(std::size_t tree) const { return _state.fall(tree); } ///< Null: the tree is whole.

    /// Modal amplitudes, then forces of the air on the patches, all times TreeFall::sway. ModalModel::poses
    /// times this vector gives the joint angles.
    /// @param vector model(tree).columns() elements.
    void poseVector(std::size_t tree, float* vector) const;
    /// Angles of each unit about its two axes, bounded by the species' maximum, radians.
    /// @param angles one per unit. @param ahead seconds for which the modes move on at their present speeds.
    void angles(std::size_t tree, glm::vec2* angles, float ahead = 0.0f) const;
    /// angles() of one unit. @param vector poseVector() of the tree.
    glm::vec2 unitAngles(std::size_t tree, std::size_t unit, const float* vector) const;
    /// Last wind at each patch times TreeFall::sway, m/s, in the tree's own axes.
    /// @param winds model(tree).patches.size() elements.
    void patchWinds(std::size_t tree, glm::vec3* winds) const;
    /// patchWinds() for each unit, in scene axes. @param winds one per unit.
    void winds(std::size_t tree, glm::vec3* winds) const;
    /// Displacement of the treetop by the modes, metres, scene axes; height z moves by (z / height)^leanPower
    /// of it (ModalLean.h).
    glm::vec2 lean(std::size_t tree) const { return _state.leans[tree]; }
    std::vector<float> amplitudes(std::size_t tree) const;
    /// Natural angular frequency of a mode, with the effect of weight, rad/s.
    float omega(std::size_t tree, std::size_t mode) const;
    /// Static amplitude of a mode under the present wind. @param vector poseVector() of the tree.
    float staticAmplitude(std::size_t tree, std::size_t mode, const float* vector) const;

protected:
    ModalState _state;
};

} // namespace osgTreeWind
