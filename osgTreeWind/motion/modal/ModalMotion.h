// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalArchetypes.h>
#include <osgTreeWind/motion/modal/ModalReader.h>
#include <osgTreeWind/motion/modal/ModalStepJob.h>
#include <osgTreeWind/wind/CanopyMap.h>

namespace osgTreeWind {

/// The law `modal` for a forest. Eight trees of an archetype are stepped at a time; the state of a tree is a
/// short vector.
///
/// Memory per tree: treeBytes(), plus its archetype. Results do not depend on threads or on the instruction
/// set and, for near trees, not on other trees. Far trees step at fixed times, staggered by group. Not
/// thread-safe, except for the threads of its executor.
class ModalMotion : public ModalReader {
public:
    using Tree = ModalTree;
    using Level = ModalLevel;
    static constexpr float farStep = ModalStepJob::farStep;

    /// @param gain on the response to wind, [0, 100]. @param exact see ModalArchetypes.
    ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact = false);
    /// An independent copy; shares the archetypes.
    ModalMotion(const ModalMotion& other) = default;
    ModalMotion& operator=(const ModalMotion&) = delete;
    /// Applies from the next step on. Null: the calling thread alone.
    void setExecutor(Executor executor);

    /// Adds a tree at rest in calm, in microseconds for any number of trees; the first tree of a size class
    /// takes milliseconds. Its model and species must outlive this object.
    /// @return its number: that of a removed tree, if there is one, otherwise treeCount().
    std::size_t add(const Tree& tree);
    void remove(std::size_t tree); ///< Frees its number for add().
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

    std::size_t archetypeCount() const { return _archetypes.size(); }
    std::size_t archetypeBytes() const { return _archetypes.bytes(); }
    /// State memory of all trees.
    std::size_t stateBytes() const { return _state.bytes() + _free.capacity() * sizeof(std::uint32_t); }
    /// State memory per tree, with all modes and patches of its level.
    static std::size_t treeBytes(Level level);

private:
    void makeArchetypes();
    void placeTree(std::size_t tree, const Tree& given, const TreeFactors& neighbours);
    std::vector<float> moveTo(std::size_t tree, std::size_t group);
    void setWinds(std::size_t tree, const float* winds, const std::vector<std::size_t>& patches);

    Executor _executor;
    InstructionSet _instructions = bestInstructionSet();
    std::size_t _turns = ModalStepJob().turns;
    ModalArchetypes _archetypes;
    std::vector<std::uint32_t> _free; ///< Numbers of removed trees.
};

} // namespace osgTreeWind
