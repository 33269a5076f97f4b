// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/MapProgram.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The features of one layer of a file, one after the other, through GDAL: GeoJSON, GeoPackage, FlatGeobuf,
/// shapefiles, GML, KML, MapInfo, OpenStreetMap, spreadsheets, and CityJSON. Used by one thread at a time. A
/// program of its own reads the file while this lives.
class VectorFile {
public:
    /// Whether a file is one of these, by its content or extension.
    static bool knows(const std::string& path);
    static Result<VectorFile> open(const std::string& path);

    const std::string& path() const { return _path; }
    /// What GDAL calls its format; "CityJSON".
    const std::string& format() const { return _head.format; }
    const std::vector<std::string>& layers() const { return _head.layers; }
    /// Chooses what next() gives. @param layer empty: the only one. @return what is wrong; empty: nothing.
    Diagnostics chooseLayer(const std::string& layer);

    // Of the layer:
    const std::vector<std::string>& columns() const { return _layer.columns; }
    const std::optional<Crs>& crs() const { return _crs; }
    bool hasGeometry() const { return _layer.hasGeometry; }
    /// What GDAL found odd.
    const std::vector<std::string>& warnings() const { return _head.warnings; }

    /// Makes the first feature the next one.
    /// @param way that its places go. @param columns to read, all if it is empty; the others have no values.
    void rewind(const CrsWay& way = {}, std::vector<std::size_t> columns = {});
    /// Goes on to the next feature; false: there is none.
    Result<bool> next();

    // Of the feature:
    /// As it is called in messages: "feature 17".
    std::string feature() const;
    bool has(std::size_t column) const;
    /// Empty where it has none.
    std::string text(std::size_t column) const;
    /// A number that is one in the file, too.
    std::optional<double> number(std::size_t column) const;
    /// Where the way brings it.
    Result<VectorPlace> place() const;

private:
    void ask();
    bool take();
    void stop();
    const FeatureBatch::Column* column(std::size_t column) const;

    std::string _path;
    std::unique_ptr<MapProgram> _program;
    FeatureFileHead _head;
    FeatureLayer _layer;
    std::optional<Crs> _crs;
    CrsWay _way;
    std::vector<std::size_t> _columns; ///< That are asked for,
    std::vector<std::size_t> _slots;   ///< and where each column of the layer is among them.
    FeatureBatch _batch;
    std::size_t _index = 0;  ///< One past the feature, in the batch.
    bool _isAsked = false;   ///< Whether the next batch is on its way.
    Diagnostics _problems{}; ///< Of the program: none can be read any more.
};

} // namespace osgTreeWind
