// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/laws/Motion.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <mutex>
#include <unordered_map>

namespace osgTreeWind {

/// The law `modal` for a placed forest: its trees in a ModalMotion, and their poses when they are asked for.
class ModalForest final : public Motion {
public:
    /// At rest. @param forest must outlive it. @param level of its trees and of those added later.
    /// @param leaves whether they flutter.
    ModalForest(const PlacedForest& forest, ModalLevel level, bool leaves, Executor executor);

    ModalMotion* modal() override { return &_sway; }
    std::unique_ptr<Motion> restarted(const PlacedForest& forest) const override;
    void setExecutor(Executor executor) override { _sway.setExecutor(std::move(executor)); }
    void meet(const WindField* wind, double time) override;
    /// Meets the wind every tenth of a second on its way.
    void step(const WindField* wind, double time, float seconds) override;
    void reset() override;
    void standIn(const CanopyFlow& wind) override;
    /// `treesAtOnce` at most, with `archetypesAtOnce` new archetypes, and as many in each step that comes.
    void followSeason() override;
    static constexpr std::size_t treesAtOnce = 256, archetypesAtOnce = 2;
    void followLeaves(const std::vector<std::size_t>& slots) override;
    void runUp(const std::vector<std::size_t>& slots, const WindField* wind, double time,
               float seconds) override {
        _sway.runUp(slots, wind, time, seconds);
    }
    Diagnostics fixed() const override { return {}; }
    std::size_t add(const PlacedTree& tree) override { return _sway.add(swayingTree(_forest, tree, _level)); }
    void remove(std::size_t slot) override;
    void replace(std::size_t slot, const PlacedTree& tree) override {
        _sway.replace(slot, swayingTree(_forest, tree, _level));
    }
    const TreeFall* fall(std::size_t slot) const override { return _sway.fall(slot); }
    void putUpright(std::size_t slot) override { _sway.putUpright(slot); }
    TreeMotion motion(std::size_t slot) const override;
    TreeMotion motion(std::size_t slot, UnitValues& values) const override;
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const override;

private:
    ModalForest(const ModalForest& other, const PlacedForest& forest);
    void followOn();
    std::vector<ModalTree> swayingTrees() const;
    UnitValues& valuesOf(std::size_t slot) const;
    void pull(std::size_t slot, UnitValues& values) const;
    void flutter(const PlacedTree& tree, UnitValues& values) const;

    const PlacedForest& _forest;
    ModalLevel _level;
    bool _withLeaves;
    ModalMotion _sway;
    double _time = 0.0;
    std::size_t _behind = ~std::size_t(0); ///< The first slot whose tree has yet to follow the season.
    mutable std::mutex _valuesMutex;       // guards _values
    mutable std::unordered_map<std::size_t, UnitValues> _values; ///< Of trees asked for.
};

} // namespace osgTreeWind
