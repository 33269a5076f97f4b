// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalArchetypes.h>
#include <osgTreeWind/motion/modal/ModalState.h>
#include <osgTreeWind/motion/modal/ModalStepJob.h>
#include <osgTreeWind/motion/modal/ModalTree.h>
#include <osgTreeWind/wind/CanopyMap.h>

#include <array>

namespace osgTreeWind {

/// The law `modal` for a forest. Eight trees of an archetype are stepped at a time; the state of a tree is a
/// short vector.
///
/// Memory per tree: treeBytes(), plus its archetype and, below a canopy, a PlaceInStand per patch. Results do
/// not depend on threads or on the instruction set and, for near trees, not on other trees. Far trees step at
/// fixed times, staggered by group. Not thread-safe, except for the threads of its executor, and for queries
/// as long as nothing changes the trees.
class ModalMotion {
public:
    using Tree = ModalTree;
    using Level = ModalLevel;
    using PoseVector = std::array<float, ModalDetail::maxModes + 3 * ModalDetail::maxPatches>;
    static constexpr float farStep = ModalStepJob::farStep;

    /// @param gain on the response to wind, [0, 100]. @param exact see ModalArchetypes.
    ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact = false);
    /// An independent copy; shares the archetypes.
    ModalMotion(const ModalMotion& other) = default;
    ModalMotion& operator=(const ModalMotion&) = delete;
    /// Applies from the next step on. Null: the calling thread alone.
    void setExecutor(Executor executor);

    /// Adds a tree at rest in calm, in microseconds for any number of trees; the first tree of a size class
    /// takes milliseconds. Its model and species must outlive this object. @param number of the tree, which
    /// no other tree has.
    void add(std::size_t number, const Tree& tree);
    void remove(std::size_t tree); ///< Frees its number.
    /// Replaces a tree; keeps its level and its motion, exactly within a size class, otherwise as a
    /// least-squares fit of the crown's motion.
    void replace(std::size_t tree, const Tree& other);
    /// Makes missing archetypes for these trees in advance, on the executor. @param most limit on new
    /// archetypes. @return the number of leading trees whose archetypes now exist.
    std::size_t makeArchetypesFor(const std::vector<Tree>& trees, std::size_t most);

    /// Applies from the next step on. Common modes and patches keep their state.
    void setLevel(std::size_t tree, Level level);
    /// Sets contact damping and shelter; crowns take the air that they shelter along as they sway.
    void setNeighbourEffect(std::size_t tree, const NeighbourEffect& neighbours);
    /// Sets the fallen parts of a tree for all queries, until it is removed or reset() is called.
    void setFall(std::size_t tree, const TreeFall& fall) {
        _state.falls[static_cast<std::uint32_t>(tree)] = fall;
    }
    void clearFall(std::size_t tree) { _state.falls.erase(static_cast<std::uint32_t>(tree)); }
    /// @param amplitudes of the archetype's modes, in order; missing ones are 0. Modal speeds become 0.
    void setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes);

    /// Takes over the wind of `time` without moving the trees. @param wind null: calm.
    void sampleWind(const WindField* wind, double time) { step(wind, time, 0.0f); }
    /// Advances by `seconds` to `time`; the wind changes linearly to that at `time`.
    void step(const WindField* wind, double time, float seconds);
    /// Steps all far trees at the same times instead of staggered over frames.
    void stepFarTreesTogether() { _turns = 1; }
    /// Gives these trees the motion that they would have after `seconds` in the wind up to `time`.
    void spinUp(const std::vector<std::size_t>& trees, const WindField* wind, double time, float seconds);
    /// Back to rest, in calm.
    void reset() { _state.reset(); }

    // Queries.

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
    /// @param ahead seconds for which the modes move on at their present speeds.
    /// @return model(tree).columns() elements, then zeros.
    PoseVector poseVector(std::size_t tree, float ahead = 0.0f) const;
    /// Angles of each unit about its two axes, bounded by the species' maximum, radians.
    /// @param angles one per unit.
    void angles(std::size_t tree, glm::vec2* angles) const;
    /// angles() of one unit. @param vector poseVector() of the tree.
    glm::vec2 unitAngles(std::size_t tree, std::size_t unit, const PoseVector& vector) const;
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
    float staticAmplitude(std::size_t tree, std::size_t mode, const PoseVector& vector) const;

    std::size_t archetypeCount() const { return _archetypes.size(); }
    std::size_t archetypeBytes() const { return _archetypes.bytes(); }
    /// State memory of all trees.
    std::size_t stateBytes() const { return _state.bytes(); }
    /// State memory per tree, with all modes and patches of its level.
    static std::size_t treeBytes(Level level);

private:
    void makeArchetypes();
    void placeTree(std::size_t tree, const Tree& given, const TreeFactors& neighbours);
    std::vector<float> moveTo(std::size_t tree, std::size_t group);
    void setWinds(std::size_t tree, const float* winds, const std::vector<std::size_t>& patches);

    ModalState _state;
    Executor _executor;
    InstructionSet _instructions = bestInstructionSet();
    std::size_t _turns = ModalStepJob().turns;
    ModalArchetypes _archetypes;
};

} // namespace osgTreeWind
