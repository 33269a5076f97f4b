// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/instanced/ScreenCover.h>

#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace osgTreeWind {

/// Trees of a view in the order in which they hide each other, in steps of their distance: trees of one step
/// do not hide each other, nor those of the next, as crowns reach into each other.
class FrontToBack {
public:
    struct Tree {
        std::uint32_t number;
        std::size_t band;  ///< Of CullLists.
        float pixels;      ///< Height on the screen.
        glm::vec3 toEye{}; ///< From its middle; forests' frame.
    };

    void clear() {
        for (std::vector<Tree>& trees : _waiting)
            trees.clear();
        _step = 0;
        _pictures.clear();
        _pending.clear();
        _cover.clear();
    }
    /// @param distance from the eye, metres; not nearer than what was taken.
    void put(const Tree& tree, float distance) {
        _waiting[std::max(_step, stepOf(distance))].push_back(tree);
    }

    /// Takes those that stand nearer than this, or at all: see(tree), with those before it in cover(),
    /// returns its picture.
    template <typename See>
    void takeBefore(float distance, See see) {
        takeSteps(stepOf(distance), see);
    }
    template <typename See>
    void takeAll(See see) {
        takeSteps(_waiting.size(), see);
    }
    /// What shows past those that were taken, as it is for whatever comes next.
    const ScreenCover& cover() const { return _cover; }

private:
    static std::size_t stepOf(float distance) {
        constexpr float depth = 6.0f; // metres
        constexpr float last = std::tuple_size_v<decltype(_waiting)> - 1;
        return static_cast<std::size_t>(std::clamp(distance / depth, 0.0f, last));
    }

    template <typename See>
    void takeSteps(std::size_t end, See see) {
        for (; _step < end; ++_step) {
            for (const Tree& tree : _waiting[_step])
                _pictures.push_back(see(tree));
            for (const ScreenCover::Picture& picture : _pending)
                _cover.add(picture);
            _pending.swap(_pictures);
            _pictures.clear();
        }
    }

    std::array<std::vector<Tree>, 128> _waiting; ///< By step; the last one is all beyond.
    std::size_t _step = 0;
    std::vector<ScreenCover::Picture> _pictures, _pending; ///< Of this step, of the one before.
    ScreenCover _cover;
};

} // namespace osgTreeWind
