// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/motion/SimulationOptions.h>
#include <osgTreeWind/motion/damage/BranchLoad.h>
#include <osgTreeWind/motion/damage/TreeSway.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

class MovingForest;
struct Skeleton;
struct TreeDamage;

/// Simulates the motion of a forest, without graphics (docs/frame.md).
///
/// Not thread-safe, except for setWind() and wind(), which any thread may call at any time.
///
///     auto simulation = ForestSimulation::create(description);
///     if (!simulation)
///         return report(simulation.problems());
///     for (double time = 0.0; time < 60.0; time += 0.1)
///         simulation.value()->advance(time);
///     use(simulation.value()->sway(TreeId(0))); // of the first tree
class OSGTREEWIND_EXPORT ForestSimulation {
public:
    /// Grows the shapes and places the trees at rest. If check() finds a problem in the description, the
    /// simulation is empty and a message goes to stderr.
    explicit ForestSimulation(ForestDescription description, const SimulationOptions& options = {});
    ~ForestSimulation();
    /// Like the constructor; returns the problems, also lack of memory.
    static Result<std::shared_ptr<ForestSimulation>> create(ForestDescription description,
                                                            const SimulationOptions& options = {});
    /// A copy with the current trees at rest in the same wind. Shares immutable data.
    std::shared_ptr<ForestSimulation> cloneAtRest() const;

    /// The description given, plus added species, but without its trees; wind and season are the first ones.
    const ForestDescription& description() const;
    /// The present forest: living trees with their names and given sizes, the current season and wind. A
    /// simulation made from it has the same trees at rest.
    ForestDescription currentDescription() const;

    std::vector<TreeId> trees() const; ///< The ids: at first in the order of the description.
    std::size_t modelCount() const;    ///< Shapes, shared by trees of a species.
    /// The wood of a shape at rest, before scaleOf() is applied. @param model not range-checked.
    const Skeleton& skeleton(std::size_t model) const;
    std::optional<std::size_t> modelOf(TreeId tree) const; ///< Index of its shape; empty: unknown tree.
    TreeScale scaleOf(TreeId tree) const;                  ///< Scale of its shape; 1 for an unknown tree.

    // Edits take a time that does not depend on the size of the forest. They return an error, and change
    // nothing, under a branchwise law, for an unknown tree, and if check() finds a problem.

    /// Grows the shapes of a species, so that trees of it can be added. Invalidates the reference that
    /// description() returned. @return its index; also an error for a duplicate name or too little memory.
    Result<std::size_t> addSpecies(Species species);
    Result<TreeId> addTree(const TreePlacement& placement); ///< Adds a tree at rest.
    [[nodiscard]] Diagnostics removeTree(TreeId tree);      ///< @return empty on success.
    /// Moves or replaces a tree, and keeps its motion; a tree of a tile becomes permanent. @return see
    /// removeTree().
    [[nodiscard]] Diagnostics changeTree(TreeId tree, const TreePlacement& placement);

    /// Under `modal`, after the first advance(): gives trees the motion that they would have after spinUpTime
    /// in the wind, in up to a millisecond per tree. From rest, their sway is then within 0.2 % of the steady
    /// response.
    void spinUp(const std::vector<TreeId>& trees);
    static constexpr float spinUpTime = 40.0f; ///< Seconds.

    bool holds(TreeId tree) const;                                 ///< Whether the forest has this tree.
    std::optional<TreeId> findTree(const std::string& name) const; ///< Empty: no tree has this name.
    std::string nameOf(TreeId tree) const;                         ///< Empty for a tree without a name.
    /// The placement that recreates a tree, with all its sizes, in world coordinates; empty: unknown tree.
    std::optional<TreePlacement> placementOf(TreeId tree) const;

    /// Sets the time of year (Season.h). Trees keep swaying; their leaves change at once, their mass, drag
    /// and damping follow. Under `modal`, each step updates up to 256 trees and two new archetypes and takes
    /// up to 10 ms longer: 100,000 trees of five species take about 700 steps. @return an error, with nothing
    /// changed, for a value that is not finite.
    [[nodiscard]] Diagnostics setSeason(float season);
    float season() const; ///< Time of year (Season.h).

    /// Sets the wind from the next advance() on. Under `modal`, it changes linearly within that step.
    /// @return what check() finds; then nothing has changed.
    [[nodiscard]] Diagnostics setWind(Wind wind);
    Wind wind() const; ///< As set.
    /// Sets how the trees change the wind, from the next advance() on. @return what check() finds; then
    /// nothing has changed.
    [[nodiscard]] Diagnostics setCanopy(const CanopySettings& canopy);
    const CanopySettings& canopy() const; ///< At first that of the description.

    void setExecutor(Executor executor); ///< See SimulationOptions::executor; from the next step on.
    Executor executor() const;           ///< The host's threads; if it gave none, the process's thread pool.

    /// Advances to `time` (seconds): samples the wind, takes one step of the law, flutters the leaves and
    /// composes the poses. The first call, and a call with an unchanged or earlier time, keeps the state (as
    /// in a pause); a time that is not finite is ignored. The laws of the thesis take one step for any
    /// elapsed time. Under `modal`, a jump of more than maxStep counts as maxStep; the wind is sampled every
    /// tenth of a second and interpolated linearly. Does not allocate in steady state. @return whether it
    /// took a step.
    bool advance(double time);
    static constexpr double maxStep = 1.0; ///< Seconds.

    /// Back to rest. Damaged trees are whole again.
    void reset();

    /// The damage of the last advance(), if the description asks for `damage`. A fallen tree exists until it
    /// is removed; changeTree() puts it upright, and currentDescription() lists it as upright.
    const std::vector<TreeDamage>& damage() const;
    bool isStanding(TreeId tree) const; ///< Whether the tree exists and has not fallen.

    /// The present state of a tree; empty for an unknown tree. The spans stay valid until the tree is changed
    /// or removed, and show the last step before the call. Under `modal` the call computes the values;
    /// different threads may call it for different trees.
    TreeMotion motion(TreeId tree) const;
    /// As above, but `modal` computes into `values`, which the result refers to.
    TreeMotion motion(TreeId tree, UnitValues& values) const;
    /// One unit of motion(), for the cost of its ancestor units; at rest for an unknown tree or unit.
    /// @param tree id of the tree. @param unit index into skeleton().units.
    UnitMotion unitMotion(TreeId tree, std::size_t unit) const;

    /// The present sway of a tree, its moment at the foot and its limit, under `modal`; empty for an unknown
    /// or fallen tree and under a branchwise law. Takes some tenths of a millisecond;
    /// different threads may call it between two calls of advance().
    std::optional<TreeSway> sway(TreeId tree) const;
    /// The present load at the base of each unit of a tree, as damage computes it; empty as sway(). A torn
    /// bough has the load that it would have on the tree. Cost and threads as sway().
    std::vector<BranchLoad> branchLoads(TreeId tree) const;

private:
    friend class Forest;
    friend MovingForest& movingForest(const ForestSimulation& simulation);
    explicit ForestSimulation(std::unique_ptr<MovingForest> forest);

    std::unique_ptr<MovingForest> _forest;
};

} // namespace osgTreeWind
