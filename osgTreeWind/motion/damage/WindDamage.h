// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/BreakableJoint.h>
#include <osgTreeWind/motion/damage/FallingTree.h>
#include <osgTreeWind/motion/damage/LeafFall.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// Wind damage in a moving forest. A tree falls in the direction of its lean if the moment at its foot
/// exceeds the resistance of its roots or stem (TreeStrength.h). A bough hangs down if its moment exceeds the
/// strength of wood as thick as its base; at most three of the 32 thickest boughs of an upright tree. In
/// autumn, loose leaves fall.
///
/// Trees are added at rest, and a tree that starts in a storm swings beyond its steady response; so loads in
/// the first `settlingTime` seconds do not break it.
class WindDamage {
public:
    static constexpr float settlingTime = 20.0f; ///< Seconds.

    /// Call after each step of the trees. @param executor null: the calling thread.
    void update(PlacedForest& forest, ModalMotion& sway, float seconds, const Executor& executor);
    /// Call if no step was taken; clears broken().
    void skipStep() { _broken.clear(); }
    /// Failures of the last step, by slot.
    const std::vector<TreeDamage>& broken() const { return _broken; }
    /// Slots of trees that have lost leaves since their loads were last updated, `most` at most. The caller
    /// updates the loads of these trees.
    std::vector<std::size_t> takeBaredTrees(const PlacedForest& forest, std::size_t most);
    /// Subtracts the leaves shed so far, after the season has reset the leaves of the forest.
    void reapplyShedding(PlacedForest& forest);
    /// Drops the state of a slot, whose tree was changed or removed.
    void clearSlot(std::size_t slot);
    void reset();

private:
    struct Joint {
        BreakableJoint base;
        float moment = 0.0f; ///< At the tree's last step, N m.
        bool fails() const { return base.limit > 0.0f && moment > base.limit; }
    };
    struct Tree {
        Joint roots, stem; ///< Both with the moment at the foot.
        std::vector<Joint> boughs;
        float age = -1.0f;    ///< Seconds; negative: the other members are not set.
        glm::vec2 lean{0.0f}; ///< At the tree's last step; far trees do not step every time.
        float shed = 0.0f;    ///< LeafFall::seasonAdvance() of the strongest wind since summer.
        float leaves = 0.0f;  ///< Share of leaves in the loads with which the tree sways.
        bool isDown = false;
    };
    struct Falling {
        std::size_t slot, part; ///< Of TreeFall::parts.
        FallingTree body;
        glm::vec2 axis; ///< Rotation axis, in the tree's own axes.
    };

    static Tree makeTree(const PlacedForest& forest, const PlacedTree& tree);
    void updateTree(PlacedForest& forest, const ModalMotion& sway, std::size_t slot, float seconds);
    void applyShedding(PlacedForest& forest, std::size_t slot) const;
    void checkTree(const PlacedForest& forest, ModalMotion& sway, std::size_t slot);
    void breakOff(const PlacedForest& forest, ModalMotion& sway, std::size_t slot, const Joint& joint,
                  DamageKind kind);

    std::vector<Tree> _trees;         ///< By slot.
    std::vector<LeafFall> _leafFalls; ///< By species.
    std::size_t _nextBared = 0;       ///< Slot at which takeBaredTrees() continues.
    std::vector<Falling> _falling;
    std::vector<TreeDamage> _broken;
};

} // namespace osgTreeWind
