// SPDX-License-Identifier: MIT
#pragma once

#include <plugins/weather/NetCdfFile.h>

#include <osgTreeWind/windfiles/EvenAxis.h>

#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// What a coordinate measures.
enum class NetCdfMeasure { None, Metres, Longitude, Latitude, Pressure, Model, Time };

/// Which dimension of an array runs where; of any other, one index is read.
struct NetCdfRoles {
    std::optional<std::size_t> time, level, y, x;
    std::optional<std::size_t> version; ///< ERA5's expver: what is final, and what is not yet.
};

/// The roles by attributes and units; otherwise by name, then by order: (time, level, y, x).
NetCdfRoles rolesOf(const NetCdfFile& file, const NetCdfArray& array);
/// What the array of its coordinates counts; None where there is none, or it does not say.
NetCdfMeasure measureOf(const NetCdfFile& file, const NetCdfDimension& dimension);
NetCdfMeasure measureOf(const NetCdfArray& coordinates);

/// Coordinates along a dimension: metres, degrees, or what else the file counts in. Empty where it has none.
std::vector<double> coordinatesOf(NetCdfFile& file, const NetCdfDimension& dimension);

/// A direction of the grid.
struct NetCdfAxis {
    std::string name;
    EvenAxis points;
    NetCdfMeasure measure = NetCdfMeasure::None;

    bool isDegrees() const {
        return measure == NetCdfMeasure::Longitude || measure == NetCdfMeasure::Latitude;
    }
};

/// Fails where its coordinates are missing, or not even.
NetCdfAxis axisOf(NetCdfFile& file, const NetCdfDimension& dimension);

/// Whether points of two axes are the same, or lie midway between.
enum class NetCdfMatch { Same, Midway, Neither };
NetCdfMatch matchOf(const NetCdfAxis& a, const NetCdfAxis& b);

/// Where points of a grid lie among those of an array: linear between two of them.
struct NetCdfPlaces {
    std::vector<std::size_t> indices; ///< To be read.
    std::vector<std::size_t>
        lower; ///< For each grid point, its lower neighbour in `indices`; empty: no interpolation.
    std::vector<float> fraction; ///< To the next.
};

/// @param targets of the grid, @param coordinates of the array; both upward or downward throughout.
NetCdfPlaces placesAmong(const std::vector<double>& coordinates, const std::vector<double>& targets);
/// Takes numbers of blocks of places.indices.size() * stride to the points of the grid; where one of two
/// neighbours has no data the other counts.
std::vector<float> atPlaces(const std::vector<float>& numbers, std::size_t stride,
                            const NetCdfPlaces& places);

} // namespace osgTreeWind
