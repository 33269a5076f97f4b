// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/modal/ModalArchetypes.h>
#include <osgTreeWind/motion/modal/ModalReader.h>
#include <osgTreeWind/motion/modal/ModalStepJob.h>
#include <osgTreeWind/wind/CanopyMap.h>

namespace osgTreeWind {

/// The law `modal` for a forest: every tree a short vector, stepped eight at a time with those of its
/// archetype.
///
/// A tree takes treeBytes() beside its archetype. What comes out does not depend on threads or on the
/// processor's instruction set, nor, for near trees, on the other trees; far ones step at times that they
/// share with those they are kept with, and that are the same whenever step() is called. Not thread-safe, but
/// for the threads of its executor.
class ModalMotion : public ModalReader {
public:
    using Tree = ModalTree;
    using Level = ModalLevel;
    static constexpr float farStep = ModalStepJob::farStep;

    /// @param gain [0, 100], on the answer to the wind. @param exact see ModalArchetypes.
    ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact = false);
    /// The same trees, which go on by themselves; shares the archetypes.
    ModalMotion(const ModalMotion& other) = default;
    ModalMotion& operator=(const ModalMotion&) = delete;
    /// From the next step on; null: the calling thread alone.
    void setExecutor(Executor executor);

    /// Puts up a tree at rest in a calm, in microseconds whatever the number of trees; the first one on its
    /// rung takes milliseconds, and its archetype stays. Its model and species must outlive this.
    /// @return its number: one that was removed, or else treeCount().
    std::size_t add(const Tree& tree);
    void remove(std::size_t tree); ///< Its number is no tree's then until add() gives it out again.
    /// Makes it another one, at its level. Keeps its sway: all of it on the same rung, else as nearly as the
    /// patches of its crown can move alike.
    void replace(std::size_t tree, const Tree& other);
    /// Makes archetypes that these trees lack, which replace() and add() then need not; `most` of them at
    /// most, on the executor. @return how many of the trees, from the first on, have theirs by now.
    std::size_t prepare(const std::vector<Tree>& trees, std::size_t most);

    /// From the next step on. What modes and patches have in common is kept.
    void setLevel(std::size_t tree, Level level);
    /// Crowns in contact damp each other, and take the air that they shelter along as they sway.
    void setCompany(std::size_t tree, const TreeCompany& company);
    /// It has come down so far, in all that is asked of it from now on. Until it is removed, or reset().
    void setFall(std::size_t tree, const TreeFall& fall) {
        _state.falls[static_cast<std::uint32_t>(tree)] = fall;
    }
    void putUpright(std::size_t tree) { _state.falls.erase(static_cast<std::uint32_t>(tree)); }
    /// Of the modes, in the order of the archetype's, at most as many as it has; speeds become 0.
    void setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes);

    /// Takes the wind of this time as that of now, without moving. @param wind null: calm.
    void meet(const WindField* wind, double time) { step(wind, time, 0.0f); }
    /// Moves on by `seconds` to `time`; the wind goes evenly to what it is then.
    void step(const WindField* wind, double time, float seconds);
    /// Has far trees step together, so that none depends on the others; else they take turns over frames.
    void stepTogether() { _turns = 1; }
    /// Has these trees sway as if they had stood there for `seconds` up to `time`, others as they do.
    void runUp(const std::vector<std::size_t>& trees, const WindField* wind, double time, float seconds);
    /// Back to rest, in a calm.
    void reset() { _state.reset(); }

    std::size_t archetypeCount() const { return _archetypes.size(); }
    std::size_t archetypeBytes() const { return _archetypes.bytes(); }
    /// Of all trees.
    std::size_t stateBytes() const { return _state.bytes() + _free.capacity() * sizeof(std::uint32_t); }
    /// Of one among many, with all the modes and patches of that level.
    static std::size_t treeBytes(Level level);

private:
    void makeArchetypes();
    void stand(std::size_t tree, const Tree& given, const TreeFactors& company);
    std::vector<float> moveTo(std::size_t tree, std::size_t group);
    void setWinds(std::size_t tree, const float* winds, const std::vector<std::size_t>& patches);

    Executor _executor;
    InstructionSet _instructions = bestInstructionSet();
    std::size_t _turns = ModalStepJob().turns;
    ModalArchetypes _archetypes;
    std::vector<std::uint32_t> _free; ///< Numbers of removed trees.
};

} // namespace osgTreeWind
