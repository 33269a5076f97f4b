// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/looks/SceneGeometry.h>
#include <osgTreeWind/motion/ForestSimulation.h>

namespace osgTreeWind {

/// A square grid of arrows that shows the undisturbed wind above a forest. They point downwind; their length
/// is 1 m for each m/s, their colour windColour().
class WindArrows : public SceneGeometry {
public:
    static constexpr int across = 24; ///< Arrows per side.

    WindArrows();

    /// Shows the wind at a time, above the trees. Between frames.
    /// @param middle centre of the grid. @param reach half its side; both in the forest's frame, metres.
    void show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach);

protected:
    ~WindArrows() override = default;
};

} // namespace osgTreeWind
