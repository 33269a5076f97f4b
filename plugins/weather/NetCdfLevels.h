// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfPoints.h>
#include <plugins/weather/NetCdfWinds.h>

#include <osgTreeWind/windfiles/WindContent.h>

#include <vector>

namespace osgTreeWind {

/// Heights of the levels of a file.
class NetCdfLevels {
public:
    /// Finds the arrays with heights, and sets the levels of the points in upward order. Fails for pressure
    /// or model levels without geopotential.
    NetCdfLevels(NetCdfFile& file, const NetCdfWinds& winds, NetCdfPoints& points);

    /// Sets the heights of a grid with velocities; levels below the terrain get the lowest wind above it.
    void setHeights(NetCdfFile& file, const NetCdfPoints& points, GridWind::Grid& grid,
                    WindSummary& summary) const;

private:
    void findLevels(NetCdfFile& file, const NetCdfArray& wind, NetCdfPoints& points);
    void findGeopotential(const NetCdfFile& file, const NetCdfArray& wind);
    void findGround(const NetCdfFile& file);
    std::vector<float> heightsOfPoints(NetCdfFile& file, const NetCdfPoints& points) const;
    bool isUpward(NetCdfFile& file, const NetCdfPoints& points) const;

    std::vector<float> _heights; ///< Heights of layers that are the same at all points.
    bool _aboveGround = false;
    double _origin = 0.0; ///< Height of the model's zero above its vertical datum, metres.
    NetCdfFile::Array _geopotential, _ground;
    double _geopotentialScale = 1.0, _groundScale = 1.0;
};

} // namespace osgTreeWind
