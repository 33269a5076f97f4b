// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/impostors/ImpostorCoverage.h>

#include <osg/Vec2>

#include <vector>

namespace osgTreeWind {

/// Share of light that passes the trees of a view, on a coarse grid over the screen. Crowns are porous: each
/// tree multiplies the transmittance of the cells that it covers.
class OcclusionBuffer {
public:
    static constexpr int columns = 192, rows = 108;

    /// The impostor of a tree on the screen: a parallelogram with horizontal upper and lower edges. Screen
    /// coordinates run from (-1, -1) to (1, 1).
    struct Billboard {
        osg::Vec2 low, high; ///< Middles of the lower and the upper edge.
        float halfWidth = 0.0f;
        const ImpostorCoverage::Grid* coverage = nullptr; ///< Null if unknown, for example close to the eye.
    };

    /// A part of a tree on the screen.
    struct Rectangle {
        osg::Vec2 low, high;         ///< Its bounds.
        osg::Vec2 coreLow, coreHigh; ///< The rectangle in which most of it lies.
        float coverage = 0.0f;       ///< Share of the core that it covers.
    };

    OcclusionBuffer() { clear(); }
    void clear() { _transmittance.assign(columns * rows, 1.0f); }
    /// Mean transmittance in front of the visible pixels of a tree, the maximum over its height. 1 off the
    /// screen and without coverage.
    float visibleShare(const Billboard& billboard) const;
    /// Whether the mean transmittance in front of it is below `negligible`, and below 5 times that
    /// everywhere. False off the screen and without coverage.
    bool isHidden(const Billboard& billboard) const;
    /// The least transmittance in a rectangle of the screen; 1 off the screen.
    float minTransmittance(const osg::Vec2& low, const osg::Vec2& high) const;
    static constexpr float negligible = 1.0f / 64; ///< Transmittance.
    /// Adds a tree in front of everything that is tested from now on.
    void add(const Billboard& billboard);

    /// Likewise. Off the screen, a part may sway into the view.
    bool isHidden(const Rectangle& part) const;
    /// Adds the core of a part in front of everything that is tested from now on.
    void add(const Rectangle& part);

private:
    std::vector<float> _transmittance; ///< Row by row from the bottom.
};

} // namespace osgTreeWind
