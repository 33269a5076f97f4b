// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/SimulationOptions.h>
#include <osgTreeWind/motion/WindCache.h>
#include <osgTreeWind/motion/branchwise/BranchwiseMotion.h>
#include <osgTreeWind/motion/damage/TreeSway.h>
#include <osgTreeWind/motion/damage/WindDamage.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>
#include <osgTreeWind/wind/WindSlot.h>

#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

namespace osgTreeWind {

class ForestSimulation;

/// A forest that moves: its trees by slot, the states of its law, its wind and its damage. ForestSimulation
/// is its public face, and documents the functions that both have. A null wind field means calm.
class MovingForest {
public:
    /// @param description must pass check(). @param wind null: a new one with the description's wind.
    MovingForest(ForestDescription description, const SimulationOptions& options,
                 std::shared_ptr<WindSlot> wind = nullptr);
    MovingForest(const MovingForest& other); ///< At rest, in a slot of its own with the same wind.
    MovingForest& operator=(const MovingForest&) = delete;

    const PlacedForest& placed() const { return _placed; } ///< The forest at rest.
    /// By slot, in the order of the description, then in the order of addition. Some are not alive.
    const std::vector<PlacedTree>& trees() const { return _placed.trees; }
    const SharedModels& models() const { return _placed.models(); } ///< Shapes, shared by trees.
    const ForestDescription& description() const { return _placed.description(); }
    ForestDescription currentDescription() const;
    std::vector<TreeId> ids() const; ///< Of the living trees, in slot order.

    /// The trees under the law `modal`; null under a branchwise law. Only this class adds and removes trees.
    ModalMotion* modal() { return _modal.get(); }
    const ModalMotion* modal() const { return _modal.get(); }
    /// The branch states of a branchwise law; null under `modal`.
    BranchwiseMotion* branches() { return _branches.get(); }
    const BranchwiseMotion* branches() const { return _branches.get(); }

    Result<std::size_t> addSpecies(Species species);
    Result<TreeId> addTree(const TreePlacement& placement);
    Diagnostics removeTree(TreeId tree);
    /// Like removeTree(), but the tree returns when its tile is loaded again.
    Diagnostics unloadTiledTree(TreeId tree);
    Diagnostics changeTree(TreeId tree, const TreePlacement& placement);
    void spinUp(const std::vector<TreeId>& trees, float seconds);
    Diagnostics setSeason(float season);
    /// Under `modal`, each step updates the leaves of at most this many trees, with at most so many new
    /// archetypes.
    static constexpr std::size_t leafUpdatesPerStep = 256, newArchetypesPerStep = 2;

    const std::shared_ptr<WindSlot>& wind() const { return _wind; } ///< Holds the wind of the host.
    const CanopySettings& canopy() const { return _windCache.canopy(); }
    Diagnostics setCanopy(const CanopySettings& canopy);
    void setForestToScene(const glm::dmat4& forestToScene) { _windCache.setForestToScene(forestToScene); }
    /// The wind not changed by the trees; the same object as long as nothing changes.
    WindFieldPtr openWind() { return _windCache.openField(_wind->get()); }

    void setExecutor(Executor executor);
    const Executor& hostExecutor() const { return _hostExecutor; }

    bool advance(double time);
    /// Replaces advance() where states are computed elsewhere (gpu/branchwise/ForestAnglePasses.h): sets the
    /// time and samples the wind. @return whether to take a step; otherwise the states stay unchanged.
    bool beginStep(double time);
    void reset();

    const std::vector<TreeDamage>& damage() const;
    bool isStanding(TreeId tree) const;
    /// Present state of a tree; empty if the slot is. The spans stay valid until the tree is removed or asked
    /// for again.
    TreeMotion motion(std::size_t slot) const;
    /// As above, but `modal` computes into `values`.
    TreeMotion motion(std::size_t slot, UnitValues& values) const;
    /// One unit of motion(), for the cost of its ancestor units. @param slot must hold a tree.
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const;
    std::optional<TreeSway> sway(TreeId tree) const;
    std::vector<BranchLoad> branchLoads(TreeId tree) const;

private:
    std::optional<float> advanceTime(double time);
    WindFieldPtr updateWind();
    void sampleWind(const WindField* wind);
    void step(const WindField* wind, float seconds);
    void treeChanged(std::size_t slot);
    ModalTree modalTree(const PlacedTree& tree) const { return makeModalTree(_placed, tree, _level); }
    void updateAllLeaves();
    void updateNextLeaves();
    void restoreLeaves();
    void breakTrees(float seconds);

    PlacedForest _placed;
    Executor _hostExecutor;                      ///< The host's; may be null.
    ModalLevel _level;                           ///< Of new trees.
    bool _withLeaves;                            ///< Whether leaves flutter.
    std::unique_ptr<ModalMotion> _modal;         ///< Null under a branchwise law.
    std::unique_ptr<BranchwiseMotion> _branches; ///< Null under `modal`.
    std::unique_ptr<WindDamage> _damage;         ///< Null: damage is off.
    std::optional<double> _time;
    std::shared_ptr<WindSlot> _wind;
    WindCache _windCache;
    WindFieldPtr _lastField;                 ///< The wind of the last step, with the canopy; null: calm.
    std::shared_ptr<const CanopyFlow> _flow; ///< That `_modal` knows; null: each tree stands alone.
    std::size_t _nextLeafUpdate = ~std::size_t(0); ///< First slot whose leaves are to be updated.
    mutable std::mutex _valuesMutex;               // guards _values
    mutable std::unordered_map<std::size_t, UnitValues> _values; ///< By slot, for motion() without `values`.
};

/// The forest behind a simulation, for techniques and controls of this library.
MovingForest& movingForest(const ForestSimulation& simulation);

} // namespace osgTreeWind
