// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/places/VectorFile.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// What an inventory has, a tree a row: a table, or a layer of features.
class TreeRows {
public:
    virtual ~TreeRows() = default;

    virtual const std::string& file() const = 0;
    /// "CSV", "OSM" (a file or a query's answer), "CityJSON", or what GDAL calls it.
    virtual const std::string& format() const = 0;
    virtual const std::vector<std::string>& columns() const = 0;
    std::optional<std::size_t> column(const std::string& name) const;
    /// That there is no column of that name, and which name is nearest.
    std::string problemOfColumn(const std::string& name) const;
    /// What its places are in, where it says so.
    virtual const std::optional<Crs>& crs() const = 0;
    /// Whether rows have a place without any column.
    virtual bool hasPlaces() const = 0;

    /// Makes the first row the next one. @param way that places of rows go which have them without any
    /// column.
    /// @param columns to read, all if it is empty; the others have no values.
    virtual void rewind(const CrsWay& way, const std::vector<std::size_t>& columns) = 0;
    /// Goes on to the next row; false: there is none.
    virtual Result<bool> next() = 0;

    // Of the row:
    virtual bool has(std::size_t column) const = 0;
    virtual std::string text(std::size_t column) const = 0;
    virtual Result<double> number(std::size_t column) const = 0;
    /// Where the way brings it, of one that has a place without any column.
    virtual Result<VectorPlace> place() const = 0;
    /// What is wrong with it. @param column its name; may be empty.
    virtual Diagnostic problem(const std::string& column, const std::string& message) const = 0;
};

class TableReader;
struct ForestReading;

/// `delimiter` and `decimal`, which a table of trees and a record of wind have.
TableOptions readTableOptions(TableReader& table);

/// The file that an [inventory] names, with its `layer`, `filter` and `delimiter`. Null, and problems, where
/// it cannot be read.
std::unique_ptr<TreeRows> openTreeRows(TableReader& table, ForestReading& reading);

} // namespace osgTreeWind
