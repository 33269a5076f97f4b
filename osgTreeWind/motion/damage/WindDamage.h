// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/FallingTree.h>
#include <osgTreeWind/motion/damage/HeldJoint.h>
#include <osgTreeWind/motion/damage/LeafFall.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <glm/vec2.hpp>

#include <vector>

namespace osgTreeWind {

/// What the wind brings down of a forest in motion: a tree whose moment at the foot exceeds what its roots or
/// its stem bear (TreeStrength.h) falls the way it leans, and lies; a bough whose moment exceeds what wood as
/// thick as its base bears comes to hang. Of a tree that stands three boughs at most, of its 32 thickest. In
/// autumn leaves go that hang loose.
///
/// Trees are put up at rest, and one that is in a storm at once swings beyond what it would ever do in it:
/// what it meets in its first `settling` seconds does not break it.
class WindDamage {
public:
    static constexpr float settling = 20.0f;

    /// After each step of those trees. @param seconds that it took. @param executor null: the calling thread.
    void follow(PlacedForest& forest, ModalMotion& sway, float seconds, const Executor& executor);
    /// No step was taken.
    void pause() { _broken.clear(); }
    /// What failed in the last step, by slot.
    const std::vector<TreeDamage>& broken() const { return _broken; }
    /// Trees that sway with more leaves than are left them, by slot: at most so many, who are then taken to
    /// sway with what they bear.
    std::vector<std::size_t> bared(const PlacedForest& forest, std::size_t most);
    /// The forest bears what the season has it bear: less what was shed of that.
    void shedAgain(PlacedForest& forest);
    /// Another tree stands there, or none.
    void forget(std::size_t slot);
    /// All stand.
    void reset();

private:
    struct Joint {
        HeldJoint base;
        float moment = 0.0f; ///< When the tree last took a step, N m.
        bool fails() const { return base.limit > 0.0f && moment > base.limit; }
    };
    struct Tree {
        Joint roots, stem; ///< Both by the moment at the foot.
        std::vector<Joint> boughs;
        float age = -1.0f;    ///< Seconds; negative: nothing of this is known yet.
        glm::vec2 lean{0.0f}; ///< When it last took a step: far trees do not in each.
        float shed = 0.0f;    ///< LeafFall::ahead() of its strongest wind since summer,
        float leaves = 0.0f;  ///< and the share of them that it sways with.
        bool isDown = false;
    };
    struct Falling {
        std::size_t slot, part; ///< Of TreeFall::parts.
        FallingTree body;
        glm::vec2 axis; ///< It turns about, in the tree's own axes.
    };

    static Tree treeOf(const PlacedForest& forest, const PlacedTree& tree);
    void meet(PlacedForest& forest, const ModalMotion& sway, std::size_t slot, float seconds);
    void shed(PlacedForest& forest, std::size_t slot) const;
    void look(const PlacedForest& forest, ModalMotion& sway, std::size_t slot);
    void breakOff(const PlacedForest& forest, ModalMotion& sway, std::size_t slot, const Joint& joint,
                  DamageKind kind);

    std::vector<Tree> _trees;         ///< By slot.
    std::vector<LeafFall> _leafFalls; ///< By species.
    std::size_t _nextBared = 0;       ///< Slot that bared() looks at first.
    std::vector<Falling> _falling;
    std::vector<TreeDamage> _broken;
};

} // namespace osgTreeWind
