// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>
#include <osgTreeWind/wind/WindField.h>

#include <memory>
#include <vector>

namespace osgTreeWind {

class BranchwiseMotion;
class CanopyFlow;
class ModalMotion;
struct TreeFall;

/// A law at work on the trees of a forest, which it knows by slot: ModalForest, where trees sway, or
/// BranchwiseMotion, where branches do. Seconds, metres, scene coordinates; a wind of null is a calm.
/// Not thread-safe, but for motion() of different trees.
class Motion {
public:
    Motion() = default;
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;
    virtual ~Motion() = default;

    /// The trees that sway in modes; null under the laws of a branch.
    virtual ModalMotion* modal() { return nullptr; }
    /// The branches that have a state each; null under the law `modal`.
    virtual BranchwiseMotion* branches() { return nullptr; }

    /// The same at rest in a calm. @param forest a copy of its own, which must outlive it.
    virtual std::unique_ptr<Motion> restarted(const PlacedForest& forest) const = 0;
    /// Threads to share the work of a step with; laws of a branch have none to share.
    virtual void setExecutor(Executor) {}

    /// Takes the wind of `time` as that of now, without moving.
    virtual void meet(const WindField* wind, double time) = 0;
    /// Moves on by `seconds` > 0 to `time`. Does not allocate in steady state.
    virtual void step(const WindField* wind, double time, float seconds) = 0;
    /// Back to rest, in a calm.
    virtual void reset() = 0;
    /// Trees stand in the company that they have in that wind: laws of a tree know of crowns that touch.
    virtual void standIn(const CanopyFlow&) {}
    /// Trees bear other leaves by now, and follow in full sway; laws of a branch know of no leaves.
    virtual void followSeason() {}
    /// Some of them do, at once.
    virtual void followLeaves(const std::vector<std::size_t>&) {}

    /// Has trees sway as if they had stood there for `seconds` up to `time`.
    virtual void runUp(const std::vector<std::size_t>&, const WindField*, double, float) {}

    /// Why its trees and species are those that it began with; empty where they come and go.
    virtual Diagnostics fixed() const {
        return {keyProblem("law", "trees and species come, go and change under the law modal only")};
    }
    // Where fixed() is empty:

    /// Puts up a tree at rest. @return its slot, for the forest to put it into.
    virtual std::size_t add(const PlacedTree&) { return 0; }
    virtual void remove(std::size_t) {}
    /// Makes the tree of a slot that one, in full sway.
    virtual void replace(std::size_t, const PlacedTree&) {}
    /// How far a tree has come down; null: it stands.
    virtual const TreeFall* fall(std::size_t) const { return nullptr; }
    virtual void putUpright(std::size_t) {}

    /// One tree as it stands now; nothing where none stands. Values stay where they are until the tree is
    /// removed or the next call for it.
    virtual TreeMotion motion(std::size_t slot) const = 0;
    /// The same; a law that works it out does so in `values`.
    virtual TreeMotion motion(std::size_t slot, UnitValues& values) const = 0;
    /// One unit of a tree that stands there: the same numbers, at the cost of the units that carry it.
    virtual UnitMotion unitMotion(std::size_t slot, std::size_t unit) const = 0;
};

} // namespace osgTreeWind
