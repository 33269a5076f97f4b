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

/// A law of motion applied to the trees of a forest, which are identified by slot: ModalForest sways whole
/// trees, BranchwiseMotion single branches. Seconds, metres, scene coordinates; a null wind means calm. Not
/// thread-safe, except for motion() of different trees.
class Motion {
public:
    Motion() = default;
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;
    virtual ~Motion() = default;

    /// The trees under the law `modal`; null under a branchwise law.
    virtual ModalMotion* modal() { return nullptr; }
    /// The branch states of a branchwise law; null under `modal`.
    virtual BranchwiseMotion* branches() { return nullptr; }

    /// A copy at rest in calm. @param forest the copy's own; must outlive it.
    virtual std::unique_ptr<Motion> cloneAtRest(const PlacedForest& forest) const = 0;
    /// Sets the threads that share the work of a step. Branchwise laws ignore it.
    virtual void setExecutor(Executor) {}

    /// Takes over the wind of `time` without moving the trees.
    virtual void sampleWind(const WindField* wind, double time) = 0;
    /// Advances by `seconds` > 0 to `time`. Does not allocate in steady state.
    virtual void step(const WindField* wind, double time, float seconds) = 0;
    /// Back to rest, in calm.
    virtual void reset() = 0;
    /// Updates crown contact and shelter from the canopy. Branchwise laws ignore it.
    virtual void setCanopyFlow(const CanopyFlow&) {}
    /// The leaf shares of all trees have changed; updates loads and keeps the motion. Branchwise laws ignore
    /// it.
    virtual void updateAllLeaves() {}
    /// Like updateAllLeaves(), for some slots and at once.
    virtual void updateLeaves(const std::vector<std::size_t>&) {}

    /// Gives trees the motion that they would have after `seconds` in the wind up to `time`.
    virtual void spinUp(const std::vector<std::size_t>&, const WindField*, double, float) {}

    /// Why trees and species cannot be edited; empty if they can.
    virtual Diagnostics editProblems() const {
        return {keyProblem("law", "only the law modal lets trees and species be added, removed or changed")};
    }
    // The rest of the edits require that editProblems() is empty.

    /// Adds a tree at rest. @return its slot; the caller puts the tree into the forest.
    virtual std::size_t add(const PlacedTree&) { return 0; }
    virtual void remove(std::size_t) {}
    /// Replaces the tree of a slot, and keeps its motion.
    virtual void replace(std::size_t, const PlacedTree&) {}
    /// The damage of a tree: its fallen parts; null if it is whole.
    virtual const TreeFall* fall(std::size_t) const { return nullptr; }
    virtual void clearFall(std::size_t) {}

    /// Present state of a tree; empty if the slot is. The spans stay valid until the tree is removed or asked
    /// for again.
    virtual TreeMotion motion(std::size_t slot) const = 0;
    /// As above; a law that computes values on request writes them to `values`.
    virtual TreeMotion motion(std::size_t slot, UnitValues& values) const = 0;
    /// One unit of motion(), for the cost of its ancestor units. @param slot must hold a tree.
    virtual UnitMotion unitMotion(std::size_t slot, std::size_t unit) const = 0;
};

} // namespace osgTreeWind
