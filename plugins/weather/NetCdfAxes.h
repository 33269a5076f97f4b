// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/windfiles/EvenAxis.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The kind of quantity of a coordinate.
enum class NetCdfMeasure { None, Metres, Longitude, Latitude, Pressure, Model, Time };

/// Indices of the dimensions of an array by role. Only the first index of other dimensions is read.
struct NetCdfRoles {
    std::optional<std::size_t> time, level, y, x;
    std::optional<std::size_t> version; ///< ERA5's expver: final and preliminary data.
};

/// Finds roles by attributes and units, otherwise by name, then by order (time, level, y, x).
NetCdfRoles rolesOf(const NetCdfFile& file, const NetCdfArray& array);
/// Kind of the coordinates of a dimension; None if it has no coordinates or they are unknown.
NetCdfMeasure measureOf(const NetCdfFile& file, const NetCdfDimension& dimension);
NetCdfMeasure measureOf(const NetCdfArray& coordinates);

/// Coordinates along a dimension in metres, degrees or other units of the file; empty if it has none.
std::vector<double> coordinatesOf(NetCdfFile& file, const NetCdfDimension& dimension);

/// An axis of the grid.
struct NetCdfAxis {
    std::string name;
    EvenAxis points;
    NetCdfMeasure measure = NetCdfMeasure::None;

    bool isDegrees() const {
        return measure == NetCdfMeasure::Longitude || measure == NetCdfMeasure::Latitude;
    }
};

/// Reads an axis. Fails if its coordinates are missing or not evenly spaced.
NetCdfAxis axisOf(NetCdfFile& file, const NetCdfDimension& dimension);

/// Whether the points of two axes are the same or midway between each other.
enum class NetCdfMatch { Same, Midway, Neither };
NetCdfMatch matchOf(const NetCdfAxis& a, const NetCdfAxis& b);

/// Linear interpolation from the points of an array to those of a grid.
struct NetCdfInterpolation {
    std::vector<std::size_t> indices; ///< Indices in the array to be read.
    /// Lower neighbour in `indices` of each grid point; empty: no interpolation.
    std::vector<std::size_t> lower;
    std::vector<float> fraction; ///< Weight of the upper neighbour.
};

/// @param coordinates of the array. @param targets coordinates of the grid. Both are monotonic.
NetCdfInterpolation interpolationBetween(const std::vector<double>& coordinates,
                                         const std::vector<double>& targets);
/// Interpolates blocks of places.indices.size() * stride numbers to the points of the grid. If one neighbour
/// has no data, the other is used.
std::vector<float> interpolate(const std::vector<float>& numbers, std::size_t stride,
                               const NetCdfInterpolation& places);

} // namespace osgTreeWind
