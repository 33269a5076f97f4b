// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/laws/Laws.h>
#include <osgTreeWind/motion/laws/TreeMotion.h>
#include <osgTreeWind/wind/WindField.h>

#include <functional>

namespace osgTreeWind {

/// The laws of the thesis (`thesis`, `thesis-smooth`; leaves: appendix D) for a forest, with a state per unit
/// and per leaf cluster. All arrays run tree after tree and, within a tree, in access order. Only the
/// constructor allocates. Trees cannot be added or removed. Not for installed headers, as Laws.h.
class BranchwiseMotion {
public:
    /// Trees start at rest. @param forest must outlive it. @param leaves whether leaves flutter. @param
    /// onTreePlaced called after each tree; may be empty.
    explicit BranchwiseMotion(const PlacedForest& forest, bool leaves = true,
                              const std::function<void()>& onTreePlaced = {});

    BranchwiseMotion(const BranchwiseMotion&) = delete;
    BranchwiseMotion& operator=(const BranchwiseMotion&) = delete;

    /// Takes over the wind of `time` without moving the trees. @param wind null: calm.
    void sampleWind(const WindField* wind, double time);
    /// Samples the wind of every unit, takes one step of the law, and composes the poses.
    void step(const WindField* wind, double time);
    void reset();                              ///< Back to rest, in calm.
    TreeMotion motion(std::size_t slot) const; ///< State of a tree; empty if the slot holds none.
    /// One unit of motion(). @param slot must hold a tree.
    UnitMotion unitMotion(std::size_t slot, std::size_t unit) const {
        const std::size_t at = _forest.trees[slot].firstUnit + unit;
        return {_poses[at], _rotations[at]};
    }

    /// Sets states computed elsewhere, at least one per unit, and composes the poses.
    void setStates(const std::vector<glm::vec4>& states);
    void setLeafStates(const std::vector<glm::vec4>& states); ///< At least one per cluster.

    const PlacedForest& forest() const { return _forest; }
    /// Where the wind is sampled: base of each unit at rest, scene coordinates, with the height above the
    /// foot of its tree.
    const std::vector<WindPlace>& windPlaces() const { return _windPlaces; }
    const std::vector<glm::vec3>& winds() const { return _winds; } ///< TreeMotion::winds.
    /// Winds in each tree's own frame, w = 0.
    const std::vector<glm::vec4>& windTexels() const { return _windTexels; }
    const std::vector<glm::vec4>& states() const { return _states; } ///< TreeMotion::states.
    /// (motionAngleX, motionAngleZ, totalRotaAngle, noise), in the leaf's own frame: TreeMotion::leaves.
    const std::vector<glm::vec4>& leafStates() const { return _leafStates; }
    const std::vector<UnitPose>& poses() const { return _poses; } ///< TreeMotion::poses.
    /// Parameters of the units for the law.
    const std::vector<Laws::ThesisBranch>& thesisBranches() const { return _branches; }

private:
    void stepBranches(const PlacedTree& tree, double time);
    void composePosesOf(const PlacedTree& tree);
    void stepLeaves(const PlacedTree& tree, double time);

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
