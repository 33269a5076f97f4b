// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/branchwise/LeafFlutter.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/Motion.h>

#include <functional>

namespace osgTreeWind {

/// The laws of a branch (`thesis`, `thesis-smooth`, `damped`) for a forest: a state per unit. All arrays run
/// tree after tree and, within a tree, in access order. Nothing allocates but the constructor
/// and followSeason(). Its trees are those that it began with.
/// Not for installed headers, as Laws.h.
class BranchwiseMotion final : public Motion {
public:
    /// At rest. @param forest must outlive it. @param leaves whether they flutter. @param placed called after
    /// each tree; may be empty.
    explicit BranchwiseMotion(const PlacedForest& forest, bool leaves = true,
                              const std::function<void()>& placed = {});

    std::unique_ptr<Motion> restarted(const PlacedForest& forest) const override;
    void setExecutor(Executor) override {}
    /// Samples the wind of every unit; the next step goes from the one before evenly to this one.
    void meet(const WindField* wind, double time) override;
    /// Samples the wind, and takes one step of the law and the poses that it leads to. The laws of the thesis
    /// take the same step however long it is.
    void step(const WindField* wind, double time, float seconds) override;
    void reset() override;
    /// State stays.
    void followSeason() override;
    /// Says that its trees and species are those that it began with.
    static Diagnostic fixed();
    Result<std::size_t> add(const PlacedTree&) override { return fixed(); }
    Diagnostics remove(std::size_t) override { return {fixed()}; }
    Diagnostics replace(std::size_t, const PlacedTree&) override { return {fixed()}; }
    TreeMotion motion(std::size_t slot) const override;
    TreeMotion motion(std::size_t slot, UnitValues&) const override { return motion(slot); }
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const override {
        const std::size_t at = _forest.trees[slot].firstUnit + unit;
        return {_poses[at], _rotations[at]};
    }

    /// Takes over states computed elsewhere, one per unit, and composes the poses.
    void setStates(const glm::vec4* states);

    const PlacedForest& forest() const { return _forest; }
    LeafFlutter& leaves() { return _leaves; }
    const LeafFlutter& leaves() const { return _leaves; }
    /// Where the wind is sampled: base of each unit at rest, scene coordinates, over ground at the foot of
    /// its tree; for `damped` above or below it, at the height of the centre of the drag on all that the unit
    /// carries.
    const std::vector<WindPlace>& windPlaces() const { return _windPlaces; }
    const std::vector<glm::vec3>& winds() const { return _winds; } ///< TreeMotion::winds.
    /// The wind at the start and at the end of the last step in the axes of each tree's own frame, w 0: two
    /// per unit.
    const std::vector<glm::vec4>& windTexels() const { return _windTexels; }
    const std::vector<glm::vec4>& states() const { return _states; } ///< TreeMotion::states.
    const std::vector<UnitPose>& poses() const { return _poses; }    ///< TreeMotion::poses.
    /// What the units are to the law of the description; the other one is empty.
    const std::vector<Laws::ThesisBranch>& thesisBranches() const { return _thesisBranches; }
    const std::vector<Laws::DampedBranch>& dampedBranches() const { return _dampedBranches; }

private:
    bool damped() const { return _forest.description().law == MotionLaw::Damped; }
    void addBranches(const PlacedTree& tree);
    void turn(const PlacedTree& tree, double time);
    void swing(const PlacedTree& tree, float seconds);
    void pose(const PlacedTree& tree);

    const PlacedForest& _forest;
    bool _withLeaves;
    LeafFlutter _leaves;
    std::vector<Laws::ThesisBranch> _thesisBranches;
    std::vector<Laws::DampedBranch> _dampedBranches;
    std::vector<WindPlace> _windPlaces;
    std::vector<glm::vec3> _winds;
    std::vector<glm::vec4> _windTexels, _states;
    std::vector<glm::quat> _rotations;
    std::vector<UnitPose> _poses;
};

} // namespace osgTreeWind
