// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/PictureCover.h>

#include <osg/Vec2>

#include <vector>

namespace osgTreeWind {

/// How much of what is behind the trees of a view still shows through them, on a coarse grid over the screen.
/// Crowns are porous, so each one lets through a share of what those before it let through.
class ScreenCover {
public:
    static constexpr int columns = 96, rows = 60;

    /// A tree's picture there: upright, its sides leaning. Screen coordinates from (-1, -1) to (1, 1).
    struct Picture {
        osg::Vec2 low, high; ///< Middle of its lower and upper edge.
        float halfWidth = 0.0f;
        const PictureCover::Grid* cover = nullptr; ///< Null: none, as near the eye.
    };

    ScreenCover() { clear(); }
    /// Nothing is before anything.
    void clear() { _shows.assign(columns * rows, 1.0f); }
    /// Share of a tree that shows about those of its pixels that do show, where that is largest up its
    /// height. 1 for one off the screen or without a picture.
    float clearness(const Picture& picture) const;
    /// Whether of a picture less than that share of the screen shows, and hardly anything of it anywhere.
    /// False without a picture.
    bool hides(const Picture& picture, float share) const;
    /// Share that shows where that is least on a part of the screen; 1 off it.
    float leastShown(const osg::Vec2& low, const osg::Vec2& high) const;
    /// Less than this is hardly anything.
    static constexpr float hardly = 0.02f;
    /// What is seen from now on is behind this one.
    void add(const Picture& picture);

private:
    std::vector<float> _shows; ///< Row by row from below.
};

} // namespace osgTreeWind
