// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/places/Crs.h>
#include <osgTreeWind/places/GridMapping.h>
#include <osgTreeWind/places/PointTable.h>
#include <osgTreeWind/places/RasterBand.h>

#include <glm/vec3.hpp>

#include <array>
#include <cstdint>

/// Messages between the library and osgtreewind-map of the same build. Wire transfers parts().
namespace osgTreeWind {

/// A request. Each has one answer, except that the rows of a raster follow its header.
struct MapRequest {
    enum class Task : unsigned char {
        ParseCrs,            ///< Text of a CRS -> Crs::Facts.
        CompareCrs,          ///< Texts of two CRSs -> whether they are the same.
        FindTransform,       ///< Texts of two CRSs -> false if the transform is the identity.
        TransformPoints,     ///< Texts of two CRSs, and places -> transformed places, NaN for failures.
        ReadGeometries,      ///< Texts of two CRSs (empty: no transform), then geometries -> GeometryBatch.
        DescribeGridMapping, ///< Text of a CRS -> GridMapping.
        ReadRaster,          ///< File, and name or number of a band -> RasterHeader, then rows.
        ReadBand,            ///< GeoTIFF file -> RasterBand.
        DetectFeatures,      ///< File -> whether it has features.
        OpenFeatures,        ///< File -> FeatureFileHeader. The tasks below refer to this file.
        ChooseLayer,         ///< Name -> FeatureLayer.
        RewindFeatures,      ///< Texts of two CRSs (empty: no transform), and columns (empty: all) ->
                             ///< MapAcknowledgement.
        NextFeatures,        ///< -> FeatureBatch.
        WriteTable,          ///< File, followed by a PointTable -> MapAcknowledgement.
        SizeOfUnit           ///< Names of a unit and a base unit -> double by sizeByUdunits().
    };
    Task task = Task::ParseCrs;
    std::vector<std::string> texts{};
    std::vector<glm::dvec2> places{};
    std::vector<std::size_t> columns{};
    bool isYFirst = false; ///< Whether geometries have (y, x).

    auto parts() { return std::tie(task, texts, places, columns, isYFirst); }
};

/// The answer to a task without a result.
struct MapAcknowledgement {};

struct RasterHeader {
    std::optional<Crs::Facts> crs;
    int columns = 0, rows = 0;
    std::array<double, 6> geotransform{}, inverseGeotransform{}; ///< As defined by GDAL.

    auto parts() { return std::tie(crs, columns, rows, geotransform, inverseGeotransform); }
};

struct FeatureFileHeader {
    std::string format;
    std::vector<std::string> layers, warnings;

    auto parts() { return std::tie(format, layers, warnings); }
};

struct FeatureLayer {
    std::string messagePrefix; ///< Empty if the file has only one layer.
    std::vector<std::string> columns;
    std::optional<Crs::Facts> crs;
    bool hasGeometry = false;

    auto parts() { return std::tie(messagePrefix, columns, crs, hasGeometry); }
};

/// Position of a feature, and width of an outline.
struct VectorPlace {
    glm::dvec3 position{0.0};      ///< The point, or an outline's centroid with z = 0.
    bool hasHeight = false;        ///< Whether the file has z.
    std::optional<double> width{}; ///< Diameter of the circle with the area of an outline.
};

/// Why a feature or a cell has no place.
struct PlaceProblem {
    std::size_t index = 0; ///< In its batch.
    std::string message;

    auto parts() { return std::tie(index, message); }
};

/// The places of texts.
struct GeometryBatch {
    std::vector<VectorPlace> places;
    std::vector<PlaceProblem> problems; ///< By ascending index.
    std::vector<std::int32_t> srids;    ///< Of EWKB; 0: none.

    auto parts() { return std::tie(places, problems, srids); }
};

/// Consecutive features with the requested columns.
struct FeatureBatch {
    enum : unsigned char { Missing, Text, Number };
    struct Column {
        std::vector<unsigned char> kinds;
        std::vector<double> numbers;
        std::string texts;                 ///< Concatenated.
        std::vector<std::uint32_t> ends{}; ///< End offset of each text.

        auto parts() { return std::tie(kinds, numbers, texts, ends); }
    };
    std::vector<std::int64_t> ids;
    std::vector<VectorPlace> places;
    std::vector<PlaceProblem> placeProblems; ///< By ascending index.
    std::vector<Column> columns;
    std::string problem; ///< An error after these features; may be empty.
    bool isLast = false;

    auto parts() { return std::tie(ids, places, placeProblems, columns, problem, isLast); }
};

} // namespace osgTreeWind
