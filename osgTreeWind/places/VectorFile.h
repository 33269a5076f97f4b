// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/places/CrsWay.h>

#include <glm/vec3.hpp>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// Where a feature is.
struct VectorPlace {
    glm::dvec3 position{0.0};      ///< Of a point, z as it has it; of an outline its centroid, z 0.
    bool hasHeight = false;        ///< Whether z is its own.
    std::optional<double> width{}; ///< Of an outline: mean of its extents along x and y.
};

/// The features of one layer of a file, one after the other, through GDAL: GeoJSON, GeoPackage, FlatGeobuf,
/// shapefiles, GML, KML, MapInfo, OpenStreetMap, spreadsheets, and CityJSON. Used by one thread at a time. A
/// program of its own reads the file while this lives.
class VectorFile {
public:
    /// Whether a file is one of these, by its content or extension.
    static bool knows(const std::string& path);
    static Result<VectorFile> open(const std::string& path);

    VectorFile();
    VectorFile(VectorFile&&) noexcept;
    VectorFile& operator=(VectorFile&&) noexcept;
    ~VectorFile();

    const std::string& path() const;
    /// What GDAL calls its format; "CityJSON".
    const std::string& format() const;
    std::vector<std::string> layers() const;
    /// Chooses what next() gives. @param layer empty: the only one. @return what is wrong; empty: nothing.
    Diagnostics chooseLayer(const std::string& layer);
    /// @param condition as behind SQL's WHERE.
    Diagnostics filter(const std::string& condition);

    // Of the layer:
    const std::vector<std::string>& columns() const;
    const std::optional<Crs>& crs() const;
    bool hasGeometry() const;
    /// What GDAL found odd.
    const std::vector<std::string>& warnings() const;

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
    struct Reading;
    explicit VectorFile(std::unique_ptr<Reading> reading);
    std::unique_ptr<Reading> _reading;
};

} // namespace osgTreeWind
