// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/motion/ForestSimulation.h>

#include <osg/Geometry>

namespace osgTreeWind {

/// A field of arrows that show the wind over a forest, as it is given: toward where the air goes, a metre of
/// length for each m/s, from dark blue (calm) over green to yellow (20 m/s and more).
class WindArrows : public osg::Geometry {
public:
    static constexpr int across = 24; ///< Arrows a side.

    WindArrows();

    /// The wind of now, above the trees. Between frames.
    /// @param middle of the field, and half of its side, the forest's coordinates, metres.
    void show(const ForestSimulation& simulation, double time, const glm::vec2& middle, float reach);

protected:
    ~WindArrows() override = default;
};

} // namespace osgTreeWind
