// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/Motion.h>

#include <functional>

namespace osgTreeWind {

/// The laws of the thesis (`thesis`, `thesis-smooth`; of leaves appendix D) for a forest: a state per unit
/// and per leaf cluster. All arrays run tree after tree and, within a tree, in access order. Nothing
/// allocates but the constructor. Its trees are those that it began with. Not for installed headers, as
/// Laws.h.
class BranchwiseMotion final : public Motion {
public:
    /// At rest. @param forest must outlive it. @param leaves whether they flutter. @param placed called after
    /// each tree; may be empty.
    explicit BranchwiseMotion(const PlacedForest& forest, bool leaves = true,
                              const std::function<void()>& placed = {});

    BranchwiseMotion* branches() override { return this; }
    std::unique_ptr<Motion> restarted(const PlacedForest& forest) const override;
    /// Samples the wind of every unit.
    void meet(const WindField* wind, double time) override;
    /// Samples the wind, and takes one step of the law, however long it is, and the poses that it leads to.
    void step(const WindField* wind, double time, float seconds) override;
    void reset() override;
    TreeMotion motion(std::size_t slot) const override;
    TreeMotion motion(std::size_t slot, UnitValues&) const override { return motion(slot); }
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const override {
        const std::size_t at = _forest.trees[slot].firstUnit + unit;
        return {_poses[at], _rotations[at]};
    }

    /// Takes over states computed elsewhere, at least one per unit, and composes the poses.
    void setStates(const std::vector<glm::vec4>& states);
    void setLeafStates(const std::vector<glm::vec4>& states); ///< Likewise, at least one per cluster.

    const PlacedForest& forest() const { return _forest; }
    /// Where the wind is sampled: base of each unit at rest, scene coordinates, over ground at the foot of
    /// its tree.
    const std::vector<WindPlace>& windPlaces() const { return _windPlaces; }
    const std::vector<glm::vec3>& winds() const { return _winds; } ///< TreeMotion::winds.
    /// The same in the axes of each tree's own frame, w 0.
    const std::vector<glm::vec4>& windTexels() const { return _windTexels; }
    const std::vector<glm::vec4>& states() const { return _states; } ///< TreeMotion::states.
    /// (motionAngleX, motionAngleZ, totalRotaAngle, noise), in the leaf's own frame: TreeMotion::leaves.
    const std::vector<glm::vec4>& leafStates() const { return _leafStates; }
    const std::vector<UnitPose>& poses() const { return _poses; } ///< TreeMotion::poses.
    /// What the units are to the law.
    const std::vector<Laws::ThesisBranch>& thesisBranches() const { return _branches; }

private:
    void turn(const PlacedTree& tree, double time);
    void pose(const PlacedTree& tree);
    void flutter(const PlacedTree& tree, double time);

    const PlacedForest& _forest;
    bool _withLeaves;
    std::vector<Laws::ThesisBranch> _branches;
    std::vector<WindPlace> _windPlaces;
    std::vector<glm::vec3> _winds;
    std::vector<glm::vec4> _windTexels, _states, _leafStates;
    std::vector<glm::quat> _rotations;
    std::vector<UnitPose> _poses;
};

} // namespace osgTreeWind
