// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Executor.h>
#include <osgTreeWind/forest/PlacedForest.h>
#include <osgTreeWind/motion/damage/FallingTree.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>
#include <osgTreeWind/motion/modal/ModalMotion.h>

#include <glm/vec2.hpp>

#include <unordered_map>
#include <vector>

namespace osgTreeWind {

/// What the wind brings down of a forest in motion: a tree whose moment at the foot exceeds what its roots or
/// its stem bear (TreeStrength.h) falls the way it leans, and lies.
///
/// Trees are put up at rest, and one that is in a storm at once swings beyond what it would ever do in it:
/// what it meets in its first `settling` seconds does not break it.
class WindDamage {
public:
    static constexpr float settling = 20.0f;

    /// After each step of those trees. @param seconds that it took. @param executor null: the calling thread.
    void follow(const PlacedForest& forest, ModalMotion& sway, float seconds, const Executor& executor);
    /// No step was taken.
    void pause() { _broken.clear(); }
    /// Those that failed in the last step, by slot.
    const std::vector<TreeDamage>& broken() const { return _broken; }
    /// Another tree stands there, or none.
    void forget(std::size_t slot);
    /// All stand.
    void reset();

private:
    /// Of a tree that stands.
    struct Limits {
        float uproot = 0.0f, breaking = 0.0f; ///< N m; 0: none known.
        float stiffness = 0.0f;               ///< Of what holds its foot, N m/rad; 0: not asked yet.
        float age = 0.0f;                     ///< Seconds.
        glm::vec2 lean{0.0f};                 ///< When it last took a step: far trees do not in each.
        float moment = 0.0f;                  ///< At its foot then, N m.
        bool isDown = false;
    };
    struct Falling {
        FallingTree body;
        unsigned unit;
        glm::vec2 axis; ///< It turns about, in the tree's own axes.
    };

    static void meet(const PlacedForest& forest, const ModalMotion& sway, std::size_t slot, float seconds,
                     Limits& limits);
    void fell(const PlacedForest& forest, const ModalMotion& sway, std::size_t slot);

    std::vector<Limits> _limits; ///< By slot.
    std::unordered_map<std::size_t, Falling> _falling;
    std::vector<TreeDamage> _broken;
};

} // namespace osgTreeWind
