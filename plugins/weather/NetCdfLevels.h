// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfPoints.h>
#include <plugins/weather/NetCdfWinds.h>

#include <osgTreeWind/windfiles/WindContent.h>

#include <vector>

namespace osgTreeWind {

/// How high the levels of a file are.
class NetCdfLevels {
public:
    /// Which of its arrays tell; puts its levels upward into the points. Fails where no heights can be told:
    /// levels of pressure or of the model without geopotential.
    NetCdfLevels(NetCdfFile& file, const NetCdfWinds& winds, NetCdfPoints& points);

    /// Puts heights into a grid that has its velocities. Levels below the model's ground get the wind of the
    /// lowest above it.
    void setHeights(NetCdfFile& file, const NetCdfPoints& points, GridWind::Grid& grid,
                    WindSummary& summary) const;

private:
    void measure(NetCdfFile& file, const NetCdfArray& wind, NetCdfPoints& points);
    void findGeopotential(const NetCdfFile& file, const NetCdfArray& wind);
    void findGround(const NetCdfFile& file);
    bool isUpward(NetCdfFile& file, const NetCdfPoints& points) const;

    std::vector<float> _heights; ///< Of the layers, where they are the same at all points.
    bool _aboveGround = false;
    double _origin = 0.0; ///< Metres above its vertical datum, of the 0 of a model with an origin of its own.
    NetCdfFile::Array _geopotential, _ground;
    double _geopotentialScale = 1.0, _groundScale = 1.0;
};

} // namespace osgTreeWind
