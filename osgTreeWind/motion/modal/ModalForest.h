// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/laws/Motion.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <mutex>
#include <unordered_map>

namespace osgTreeWind {

/// The law `modal` for a placed forest; computes poses on request.
class ModalForest final : public Motion {
public:
    /// Trees start at rest. @param forest must outlive it. @param level of all trees.
    /// @param leaves whether leaves flutter.
    ModalForest(const PlacedForest& forest, ModalLevel level, bool leaves, Executor executor);

    ModalMotion* modal() override { return &_sway; }
    std::unique_ptr<Motion> cloneAtRest(const PlacedForest& forest) const override;
    void setExecutor(Executor executor) override { _sway.setExecutor(std::move(executor)); }
    void sampleWind(const WindField* wind, double time) override;
    /// Samples the wind every tenth of a second.
    void step(const WindField* wind, double time, float seconds) override;
    void reset() override;
    void setCanopyFlow(const CanopyFlow& wind) override;
    /// Updates at most leafUpdatesPerStep trees with newArchetypesPerStep new archetypes per step.
    void updateAllLeaves() override;
    static constexpr std::size_t leafUpdatesPerStep = 256, newArchetypesPerStep = 2;
    void updateLeaves(const std::vector<std::size_t>& slots) override;
    void spinUp(const std::vector<std::size_t>& slots, const WindField* wind, double time,
                float seconds) override {
        _sway.spinUp(slots, wind, time, seconds);
    }
    Diagnostics editProblems() const override { return {}; }
    std::size_t add(const PlacedTree& tree) override {
        return _sway.add(makeModalTree(_forest, tree, _level));
    }
    void remove(std::size_t slot) override;
    void replace(std::size_t slot, const PlacedTree& tree) override {
        _sway.replace(slot, makeModalTree(_forest, tree, _level));
    }
    const TreeFall* fall(std::size_t slot) const override { return _sway.fall(slot); }
    void clearFall(std::size_t slot) override { _sway.clearFall(slot); }
    TreeMotion motion(std::size_t slot) const override;
    TreeMotion motion(std::size_t slot, UnitValues& values) const override;
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const override;

private:
    ModalForest(const ModalForest& other, const PlacedForest& forest);
    void updateNextLeaves();
    std::vector<ModalTree> makeModalTrees() const;
    UnitValues& valuesOf(std::size_t slot) const;
    void pull(std::size_t slot, UnitValues& values) const;
    void flutter(const PlacedTree& tree, UnitValues& values) const;

    const PlacedForest& _forest;
    ModalLevel _level;
    bool _withLeaves;
    ModalMotion _sway;
    double _time = 0.0;
    std::size_t _nextLeafUpdate = ~std::size_t(0); ///< First slot whose leaves are to be updated.
    mutable std::mutex _valuesMutex;               // guards _values
    mutable std::unordered_map<std::size_t, UnitValues> _values; ///< By slot, for motion() without `values`.
};

} // namespace osgTreeWind
