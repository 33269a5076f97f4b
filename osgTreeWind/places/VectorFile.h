// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/places/MapProgram.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Reads the features of a vector file one by one through GDAL: GeoJSON, GeoPackage, FlatGeobuf, shapefiles,
/// GML, KML, MapInfo, OpenStreetMap, spreadsheets, and CityJSON. A separate process reads the file while this
/// object exists. Only one thread at a time may use it.
class VectorFile {
public:
    /// Whether a file has a supported format, by its content or extension.
    static bool isSupported(const std::string& path);
    static Result<VectorFile> open(const std::string& path);

    const std::string& path() const { return _path; }
    /// GDAL's name of the format, or "CityJSON".
    const std::string& format() const { return _header.format; }
    const std::vector<std::string>& layers() const { return _header.layers; }
    /// Selects the layer to read. @param layer empty: the only one.
    Diagnostics chooseLayer(const std::string& layer);

    // The selected layer:
    const std::vector<std::string>& columns() const { return _layer.columns; }
    const std::optional<Crs>& crs() const { return _crs; }
    bool hasGeometry() const { return _layer.hasGeometry; }
    /// Warnings of GDAL, and the encoding that was assumed for the texts read so far.
    const std::vector<std::string>& warnings() const { return _header.warnings; }

    /// From the next rewind() on, takes the coordinates of geometries for (y, x).
    void setYFirst() { _isYFirst = true; }
    /// Restarts before the first feature.
    /// @param transform for the places. @param columns to read; empty: all. Other columns have no values.
    void rewind(const CrsTransform& transform = {}, std::vector<std::size_t> columns = {});
    /// Advances to the next feature. @return false at the end.
    Result<bool> next();

    // The current feature:
    /// Its name in messages: "feature 17".
    std::string feature() const;
    bool has(std::size_t column) const;
    /// Empty if it has no value.
    std::string text(std::size_t column) const;
    /// The value, if the file stores it as a number.
    std::optional<double> number(std::size_t column) const;
    /// Its transformed place.
    Result<VectorPlace> place() const;

private:
    void requestBatch();
    bool receiveBatch();
    void discardPendingBatch();
    void recode(FeatureBatch::Column& column);
    void noteRecoding();
    const FeatureBatch::Column* column(std::size_t column) const;

    std::string _path;
    std::unique_ptr<MapProgram> _program;
    FeatureFileHeader _header;
    FeatureLayer _layer;
    std::optional<Crs> _crs;
    CrsTransform _transform;
    bool _isYFirst = false;
    std::vector<std::size_t> _columns;      ///< Requested columns.
    std::vector<std::size_t> _batchColumns; ///< Index in the batch of each column of the layer.
    FeatureBatch _batch;
    std::size_t _index = 0;       ///< One past the current feature in the batch.
    bool _isRecoded = false;      ///< Whether a text was no UTF-8.
    bool _isBatchPending = false; ///< The next batch is requested but not received.
    Diagnostics _problems{};      ///< Errors of the program, after which it cannot be read.
};

} // namespace osgTreeWind
