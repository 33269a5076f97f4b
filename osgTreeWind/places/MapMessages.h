// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/places/GridMapping.h>
#include <osgTreeWind/places/MapCells.h>
#include <osgTreeWind/places/PointTable.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

/// What passes between the library and osgtreewind-map, which are of the same build. Not part of the
/// interface. parts() are what Wire passes.
namespace osgTreeWind {

/// One question; each has one answer, but for a raster, whose rows follow its head.
struct MapQuestion {
    enum class Task : unsigned char {
        ParseCrs,       ///< A text: Crs::Facts.
        CompareCrs,     ///< Two texts: whether places of both mean the same.
        FindWay,        ///< From a text to another: whether there is anything to do.
        BringPlaces,    ///< From one system to another: the places there, NaN where there is none.
        DescribeMap,    ///< A text: GridMapping.
        ReadRaster,     ///< A file, and the name or number of a band: RasterHead, then rows.
        ReadCells,      ///< A GeoTIFF: MapCells.
        KnowFeatures,   ///< A file: whether it has features.
        OpenFeatures,   ///< A file: FeatureFileHead. The tasks below are about it.
        ChooseLayer,    ///< A name: FeatureLayer.
        RewindFeatures, ///< Places from a text to another, and which columns: all where none is named.
        NextFeatures,   ///< FeatureBatch.
        WriteTable      ///< A file; the PointTable follows.
    };
    Task task = Task::ParseCrs;
    std::vector<std::string> texts{};
    std::vector<glm::dvec2> places{};
    std::vector<std::size_t> columns{};

    auto parts() { return std::tie(task, texts, places, columns); }
};

/// A task that has nothing to say but that it is done.
struct MapDone {};

struct RasterHead {
    std::optional<Crs::Facts> crs;
    int columns = 0, rows = 0;
    std::array<double, 6> toPlace{}, toCell{}; ///< GDAL's geotransform, and its inverse.

    auto parts() { return std::tie(crs, columns, rows, toPlace, toCell); }
};

struct FeatureFileHead {
    std::string format;
    std::vector<std::string> layers, warnings;

    auto parts() { return std::tie(format, layers, warnings); }
};

struct FeatureLayer {
    std::string where; ///< As messages begin; empty where there is only one.
    std::vector<std::string> columns;
    std::optional<Crs::Facts> crs;
    bool hasGeometry = false;

    auto parts() { return std::tie(where, columns, crs, hasGeometry); }
};

/// Where a feature is.
struct VectorPlace {
    glm::dvec3 position{0.0};      ///< Of a point, z as it has it; of an outline its centroid, z 0.
    bool hasHeight = false;        ///< Whether z is its own.
    std::optional<double> width{}; ///< Of an outline: mean of its extents along x and y.
};

/// Features one after another; of each the columns that were asked for.
struct FeatureBatch {
    enum : unsigned char { Missing, Text, Number };
    struct Column {
        std::vector<unsigned char> kinds;
        std::vector<double> numbers;
        std::string texts;                 ///< One behind the other,
        std::vector<std::uint32_t> ends{}; ///< and where each ends.

        auto parts() { return std::tie(kinds, numbers, texts, ends); }
    };
    /// Why the feature of this index has no place.
    struct Placeless {
        std::size_t index = 0;
        std::string message;

        auto parts() { return std::tie(index, message); }
    };
    std::vector<std::int64_t> ids;
    std::vector<VectorPlace> places;
    std::vector<Placeless> placeless; ///< In order.
    std::vector<Column> columns;
    std::string problem; ///< What comes after them; empty: more features, or nothing.
    bool isLast = false;

    auto parts() { return std::tie(ids, places, placeless, columns, problem, isLast); }
};

} // namespace osgTreeWind
