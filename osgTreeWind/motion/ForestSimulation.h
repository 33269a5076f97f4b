// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Export.h>
#include <osgTreeWind/base/Result.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/forest/TreeId.h>
#include <osgTreeWind/motion/SimulationOptions.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

class CanopyFlow;
class GivenWind;
class Motion;
class WindAmongTrees;
class WindDamage;
struct PlacedForest;
struct Skeleton;
struct TreeDamage;

/// A forest in motion, without graphics (docs/frame.md).
///
/// Not thread-safe, but for setWind() and wind(), which any thread may call at any time.
///
///     ForestSimulation simulation(description);
///     for (double time = 0.0; time < 60.0; time += 0.1)
///         simulation.advance(time);
///     use(simulation.motion(0)); // of the first tree
class OSGTREEWIND_EXPORT ForestSimulation {
public:
    /// Grows the shapes and places the trees at rest. A description for which check() finds something is
    /// refused: the simulation is empty, and stderr says why.
    explicit ForestSimulation(ForestDescription description, const SimulationOptions& options = {});
    ~ForestSimulation();
    /// The same trees as they are by now, at rest, in the same wind. Shares what does not change.
    std::shared_ptr<ForestSimulation> restarted() const;

    /// As given, with species that were added, but without its trees, and with its first wind and season.
    const ForestDescription& description() const;
    /// The forest as it is now: the trees that are alive, with the sizes they were given and names, in the
    /// season and in the wind of now. One made of it has the same trees at rest; its `source` is empty.
    ForestDescription describe() const;

    std::size_t slotCount() const;  ///< In the order of the description, then as added; some may be empty.
    std::size_t modelCount() const; ///< Shapes, which trees of a species share.
    /// The wood of a shape at rest, before it is stretched by scaleOf() a tree. @param model unchecked.
    const Skeleton& skeleton(std::size_t model) const;
    std::size_t modelOf(std::size_t slot) const; ///< The shape of the tree in a slot; unchecked.
    TreeScale scaleOf(std::size_t slot) const;   ///< How its shape is stretched.

    // Trees come and go in a time that does not depend on the forest. It is a problem, and nothing is
    // changed, under a law of a branch, where there is no such tree, and where check() finds something.

    /// Grows the shapes of a species, of which trees may then be added. The reference that description() gave
    /// before is no longer valid. @return its index there, or also a name that is taken, and no memory.
    Result<std::size_t> addSpecies(Species species);
    Result<TreeId> addTree(const TreePlacement& placement); ///< Puts up a tree at rest.
    Diagnostics removeTree(TreeId tree);                    ///< @return the problems; empty when it is done.
    /// Moves it, or makes it another one, in full sway; one of a tile becomes the forest's own. @return as
    /// removeTree().
    Diagnostics changeTree(TreeId tree, const TreePlacement& placement);

    /// Under `modal`, once it was advanced: has trees that it holds sway as if they had stood there for the
    /// last runUpTime, which takes up to a millisecond a tree. From rest one sways within 0.2 % as one that
    /// was always there.
    void runUp(const std::vector<TreeId>& trees);
    static constexpr float runUpTime = 40.0f; ///< Seconds.

    bool holds(TreeId tree) const;                                     ///< Whether it is there.
    std::size_t slotOf(TreeId tree) const { return slotOfTree(tree); } ///< Where it stands.
    /// Of the tree in a slot; the description's have their numbers, 0 and up.
    TreeId idOf(std::size_t slot) const;
    std::optional<TreeId> findTree(const std::string& name) const; ///< None has it: nothing.
    std::string nameOf(TreeId tree) const;                         ///< Empty for none.
    /// What would put that tree up again, with all of its sizes, in world coordinates. Only of one it holds.
    TreePlacement placementOf(TreeId tree) const;

    /// Of the year (Season.h), which all trees follow in full sway: the leaves they bear, at once, and by
    /// them their mass, drag and damping. Under `modal` 256 trees at most, and two new archetypes, do so at
    /// once and in each step that comes, which takes up to 10 ms more: 100,000 trees of five species follow
    /// within some 700 steps. @return a problem, and nothing is changed, for what is not finite.
    Diagnostics setSeason(float season);
    float season() const; ///< Of the year.

    /// The wind from the next advance() on; under `modal` trees go to it evenly within that step.
    void setWind(Wind wind);
    Wind wind() const; ///< As set.

    void setExecutor(Executor executor); ///< As SimulationOptions::executor, from the next step on.
    Executor executor() const;           ///< The threads that a host lends, else those of the process.

    /// Moves on to `time` (seconds): samples the wind, takes one step of the law, flutters the leaves,
    /// composes the poses. The first call, and a call with an unchanged or earlier time, keeps the state (a
    /// pause holds), and a time that is not finite is ignored. The laws of the thesis take one step however
    /// much time has passed. Under `modal` a jump of more than maxStep seconds counts as maxStep; the wind
    /// goes evenly from the sample before to this one, with one every tenth of a second on its way. Does not
    /// allocate in steady state. @return whether a step was taken.
    bool advance(double time);
    static constexpr double maxStep = 1.0; ///< Seconds.

    /// Back to rest; trees that have come down stand again.
    void reset();

    /// What the wind has brought down in the last advance(), where the description asks for `damage`. Such a
    /// tree is there until it is removed, and changeTree() puts it up again; describe() has it stand.
    const std::vector<TreeDamage>& damage() const;
    /// Whether it is there and has not come down.
    bool stands(TreeId tree) const;

    /// One tree as it stands now; nothing where none stands. Its values stay where they are until it is
    /// changed or removed, and are those of the last step before the call; under `modal` they are worked out
    /// by the call, which different threads may make for different trees.
    TreeMotion motion(std::size_t slot) const;
    /// The same, under `modal` worked out into `values` instead of memory of the simulation's own: they stay
    /// until `values` is used again.
    TreeMotion motion(std::size_t slot, UnitValues& values) const;

    /// One unit of a tree that stands there: the same numbers, at the cost of the units that carry it.
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const;

private:
    friend struct SimulationParts;
    ForestSimulation(ForestDescription description, const SimulationOptions& options,
                     std::shared_ptr<GivenWind> wind);
    ForestSimulation(const ForestSimulation& other);
    Diagnostics unloadTree(TreeId tree);
    bool beginStep(double time);
    std::optional<float> elapsedAt(double time);
    WindFieldPtr windHere();
    void treeChanged(std::size_t slot);
    void regrow();

    std::unique_ptr<PlacedForest> _forest;
    Executor _lent;
    std::unique_ptr<Motion> _motion;
    std::optional<double> _time;
    std::shared_ptr<GivenWind> _wind;
    std::unique_ptr<WindAmongTrees> _amongTrees;
    std::unique_ptr<WindDamage> _damage;      ///< Null: no wind does any.
    std::shared_ptr<const CanopyFlow> _stand; ///< In which the trees have their company; null: alone.
};

} // namespace osgTreeWind
