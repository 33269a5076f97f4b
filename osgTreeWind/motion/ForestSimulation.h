// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/LeafFlutter.h>
#include <osgTreeWind/motion/PlacedForest.h>
#include <osgTreeWind/motion/TreeMotion.h>

#include <functional>
#include <memory>
#include <mutex>
#include <optional>

namespace osgTreeWind {

class BranchwiseMotion;

/// A forest in motion, without graphics: the `cpu` way to the pose (design, "The frame").
///
/// Not thread-safe, but for setWind() and wind(), which any thread may call at any time.
class ForestSimulation {
public:
    /// Grows the shapes and places the trees at rest. Trees of a species that is not there are left out.
    /// @param placed called after each tree, for a person who waits; may be empty.
    explicit ForestSimulation(ForestDescription description, const std::function<void()>& placed = {});
    ~ForestSimulation();

    /// As given, but for trees left out; its wind is the first one, whatever setWind() did.
    const ForestDescription& description() const { return _forest.description; }
    const std::vector<TreeModel>& models() const { return _forest.models; }
    /// In the order of the description.
    const std::vector<PlacedTree>& trees() const { return _forest.trees; }
    /// All of it.
    const PlacedForest& forest() const { return _forest; }

    /// The wind from the next advance() on; `damped` goes to it evenly within that step. Null: calm.
    void setWind(WindFieldPtr wind);
    WindFieldPtr wind() const;

    /// Moves on to `time` (seconds): samples the wind, takes one step of the law, flutters the leaves,
    /// composes the poses. The first call, and a call with an unchanged or earlier time, keeps the state (a
    /// pause holds), and a time that is not finite is ignored. The laws of the thesis take one step however
    /// much time has passed; for `damped` a jump of more than maxStep counts as maxStep, and the wind goes
    /// evenly from the sample before to this one.
    /// Does not allocate.
    /// @return whether a step was taken.
    bool advance(double time);
    static constexpr double maxStep = 0.1;

    /// Back to rest.
    void reset();

    /// One tree as it stands now. Its values stay where they are as long as the simulation lives, and are
    /// those of the last step taken before the call.
    TreeMotion motion(std::size_t tree) const;

    // What follows is for those who work out states elsewhere (gpu/AnglePrePass.h).

    /// The first half of advance(): moves on to `time` and samples the wind.
    /// @return seconds to step, or nothing when the state is to be kept.
    std::optional<float> beginStep(double time);
    /// The branches; null where the law has no state for each of them.
    BranchwiseMotion* branches() { return _branches.get(); }
    const BranchwiseMotion* branches() const { return _branches.get(); }
    LeafFlutter& leaves() { return _leaves; }
    const LeafFlutter& leaves() const { return _leaves; }

private:
    const PlacedForest _forest;
    const std::unique_ptr<BranchwiseMotion> _branches;
    LeafFlutter _leaves;
    std::optional<double> _time;
    mutable std::mutex _windMutex; // guards _wind
    WindFieldPtr _wind;
};

} // namespace osgTreeWind
