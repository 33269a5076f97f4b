// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/motion/modal/Archetype.h>
#include <osgTreeWind/motion/modal/ModalTree.h>
#include <osgTreeWind/motion/modal/TreeFall.h>
#include <osgTreeWind/wind/TreeCompany.h>
#include <osgTreeWind/wind/WindField.h>

#include <glm/vec2.hpp>

#include <map>
#include <memory>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// The law `modal` for a forest: every tree a short vector, stepped eight at a time with those of its
/// archetype.
///
/// A tree takes treeBytes() beside its archetype. What comes out does not depend on threads or on the
/// processor's instruction set, nor, for near trees, on the other trees; far ones step at times that they
/// share with those they are kept with, and that are the same whenever step() is called. Not thread-safe, but
/// for the threads of its executor.
class ModalMotion {
public:
    using Tree = ModalTree;
    using Level = ModalLevel;
    static constexpr float farStep = 0.2f; ///< Seconds from one step of a far tree to the next.

    /// @param gain [0, 100], on the answer to the wind. @param exact gives each tree an archetype of its own
    /// instead of that of the nearest rung, which takes milliseconds and tens of kB a tree.
    ModalMotion(const std::vector<Tree>& trees, float gain, Executor executor, bool exact = false);
    ~ModalMotion();
    /// The same trees, which go on by themselves; shares the archetypes.
    ModalMotion(const ModalMotion& other);
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
    bool holds(std::size_t tree) const;
    /// Makes archetypes that these trees lack, which replace() and add() then need not; `most` of them at
    /// most, on the executor. @return how many of the trees, from the first on, have theirs by now.
    std::size_t prepare(const std::vector<Tree>& trees, std::size_t most);

    /// Numbers given out, those of removed trees too.
    std::size_t treeCount() const { return _leans.size(); }
    std::size_t archetypeCount() const { return _archetypes.size(); }
    const Archetype& archetype(std::size_t tree) const;
    const ModalModel& model(std::size_t tree) const; ///< Its archetype's, at its present level.
    TreeFactors factors(std::size_t tree) const;     ///< Its sizes over its archetype's.

    /// From the next step on. What modes and patches have in common is kept.
    void setLevel(std::size_t tree, Level level);
    /// Crowns in contact damp each other, and take the air that they shelter along as they sway.
    void setCompany(std::size_t tree, const TreeCompany& company);
    Level level(std::size_t tree) const;

    /// It has come down so far, in all that is asked of it from now on. Until it is removed, or reset().
    void setFall(std::size_t tree, const TreeFall& fall) { _falls[static_cast<std::uint32_t>(tree)] = fall; }
    void putUpright(std::size_t tree) { _falls.erase(static_cast<std::uint32_t>(tree)); }
    /// Null: it stands.
    const TreeFall* fall(std::size_t tree) const;

    /// Takes the wind of this time as that of now, without moving. @param wind null: calm.
    void meet(const WindField* wind, double time);
    /// Moves on by `seconds` > 0 to `time`; the wind goes evenly to what it is then.
    void step(const WindField* wind, double time, float seconds);
    /// Has far trees step together, so that none depends on the others; else they take turns over frames.
    void stepTogether() { _turns = 1; }
    /// Has these trees sway as if they had stood there for `seconds` up to `time`, others as they do.
    void runUp(const std::vector<std::size_t>& trees, const WindField* wind, double time, float seconds);
    /// Back to rest, in a calm.
    void reset();

    /// What the pose is a matrix times: amplitudes of the modes, then forces of the air on the patches.
    /// @param vector model(tree).columns() elements.
    void poseVector(std::size_t tree, float* vector) const;
    /// Angles of each unit about its two axes as the tree stands, held within the
    /// species' largest. @param angles one per unit.
    void angles(std::size_t tree, glm::vec2* angles) const;
    /// Those of one unit. @param vector poseVector() of the tree.
    glm::vec2 unitAngles(std::size_t tree, std::size_t unit, const float* vector) const;
    /// The wind that each patch met last, m/s, in the tree's own axes.
    /// @param winds model(tree).patches.size() elements.
    void patchWinds(std::size_t tree, glm::vec3* winds) const;
    /// How far its modes have moved the top of the tree, metres, scene axes; height z has moved by
    /// (z / height)^leanPower of that (ModalLean.h).
    glm::vec2 lean(std::size_t tree) const { return _leans[tree]; }
    /// Per unit: the wind that its patch met last, m/s, scene axes.
    void winds(std::size_t tree, glm::vec3* winds) const;

    /// Amplitudes of the modes, in the order of the archetype's, at most as many as it has; speeds become 0.
    void setAmplitudes(std::size_t tree, const std::vector<float>& amplitudes);
    std::vector<float> amplitudes(std::size_t tree) const;

    std::size_t stateBytes() const; ///< Of all trees.
    /// Of one among many, with all the modes and patches of that level.
    static std::size_t treeBytes(Level level);
    std::size_t archetypeBytes() const;

private:
    struct Group;
    struct Slot;
    struct Place;
    struct Work;
    struct Scratch;

    std::uint32_t archetypeOf(const SwayingTree& form);
    void addArchetypes(const std::vector<SwayingTree>& forms);
    void put(std::size_t tree, std::size_t group);
    void take(std::size_t tree);
    void stand(std::size_t tree, const Tree& given, const TreeFactors& company);
    const Group& groupOf(std::size_t tree) const;
    float& number(std::size_t tree, std::size_t index);
    float number(std::size_t tree, std::size_t index) const;
    void advance(const WindField* wind);
    void sampleWind(const WindField* wind, std::size_t first, std::size_t end, Scratch& scratch) const;
    WindPlace* addPlaces(const Work& work, WindPlace* out) const;
    void settle(std::size_t tree, std::size_t first);
    void refreshLean(std::size_t tree);
    float shareOfSway(std::size_t tree) const;

    Executor _executor;
    float _gain;
    InstructionSet _instructions = bestInstructionSet();
    bool _exact;
    std::size_t _turns = 16;                       ///< Into which steps of far trees are spread.
    std::map<ArchetypeRung, std::uint32_t> _rungs; ///< To an index of `_archetypes`.
    std::vector<std::shared_ptr<const Archetype>> _archetypes;
    std::vector<Group> _groups;       ///< Two for each archetype, one a level.
    std::vector<Slot> _slots;         ///< Per tree.
    std::vector<Place> _places;       ///< Per tree.
    std::vector<glm::vec2> _leans;    ///< Per tree.
    std::vector<std::uint32_t> _free; ///< Numbers of removed trees.
    std::unordered_map<std::uint32_t, TreeFall> _falls;
    std::vector<Work> _work; ///< Of the step at hand.
};

} // namespace osgTreeWind
