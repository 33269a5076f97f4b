// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalState.h>
#include <osgTreeWind/motion/modal/ModalTree.h>

namespace osgTreeWind {

/// How trees under the law `modal` stand. Any thread, as long as nothing changes them.
class ModalReader {
public:
    /// Numbers given out, those of removed trees too.
    std::size_t treeCount() const { return _state.slots.size(); }
    bool holds(std::size_t tree) const {
        return tree < _state.slots.size() && _state.slots[tree].group != ModalState::Slot().group;
    }
    const Archetype& archetype(std::size_t tree) const { return *_state.groupOf(tree).archetype; }
    /// Its archetype's, at its present level.
    const ModalModel& model(std::size_t tree) const { return _state.groupOf(tree).model(); }
    ModalLevel level(std::size_t tree) const { return static_cast<ModalLevel>(_state.groupOf(tree).level); }
    /// Its sizes over its archetype's.
    TreeFactors factors(std::size_t tree) const { return _state.factors(tree); }
    const TreeFall* fall(std::size_t tree) const { return _state.fall(tree); } ///< Null: it stands.

    /// What the pose is a matrix times: amplitudes of the modes, then forces of the air on the patches.
    /// @param vector model(tree).columns() elements.
    void poseVector(std::size_t tree, float* vector) const;
    /// Angles of each unit about its two axes as the tree stands, held within the species' largest.
    /// @param angles one per unit.
    void angles(std::size_t tree, glm::vec2* angles) const;
    /// Those of one unit. @param vector poseVector() of the tree.
    glm::vec2 unitAngles(std::size_t tree, std::size_t unit, const float* vector) const;
    /// The wind that each patch met last, m/s, in the tree's own axes.
    /// @param winds model(tree).patches.size() elements.
    void patchWinds(std::size_t tree, glm::vec3* winds) const;
    /// Per unit: the wind that its patch met last, m/s, scene axes.
    void winds(std::size_t tree, glm::vec3* winds) const;
    /// How far its modes have moved the top of the tree, metres, scene axes; height z has moved by
    /// (z / height)^leanPower of that (ModalLean.h).
    glm::vec2 lean(std::size_t tree) const { return _state.leans[tree]; }
    std::vector<float> amplitudes(std::size_t tree) const;
    /// The amplitude at which the air of now holds a mode. @param vector poseVector() of the tree.
    float heldAmplitude(std::size_t tree, std::size_t mode, const float* vector) const;

protected:
    ModalState _state;
};

} // namespace osgTreeWind
