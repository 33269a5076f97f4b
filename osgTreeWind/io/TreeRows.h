// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/RowExpression.h>
#include <osgTreeWind/base/TableText.h>
#include <osgTreeWind/places/VectorFile.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace osgTreeWind {

/// Reads the rows of an inventory one by one: a table or a layer of vector features, with one tree per row.
/// Columns are those of the file, and expressions over them.
class TreeRows : private RowCells {
public:
    ~TreeRows() override = default;

    virtual const std::string& file() const = 0;
    /// "CSV", "OSM" (a file or the answer to a query), "CityJSON", or GDAL's name of the format.
    virtual const std::string& format() const = 0;
    /// Of the file.
    virtual const std::vector<std::string>& columns() const = 0;
    std::optional<std::size_t> column(const std::string& name) const;
    /// The column with this name, or the expression, which is added to the columns.
    Result<std::size_t> columnOrExpression(const std::string& text);
    /// The name of a column, or the text of an expression.
    const std::string& nameOf(std::size_t column) const;
    /// The unit that a column of the file gives, as by unitInName().
    virtual std::string unitOf(Dimension dimension, std::size_t column) const {
        return unitInName(dimension, columns()[column]);
    }
    /// The CRS, if the file states it.
    virtual const std::optional<Crs>& crs() const = 0;
    /// Whether rows have a geometry.
    virtual bool hasPlaces() const = 0;
    /// Notes on the rows read so far.
    virtual std::vector<std::string> warnings() const { return {}; }

    /// From the next rewind() on, takes the coordinates of geometries for (y, x).
    virtual void setYFirst() {}
    /// From now on, leaves out the rows that do not match.
    void setFilter(RowExpression filter) { _filter = std::move(filter); }
    /// Restarts before the first row. @param transform for places of geometries. @param columns to read;
    /// empty: all. Other columns have no values.
    void rewind(const CrsTransform& transform, std::vector<std::size_t> columns);
    /// Advances to the next row. @return false at the end.
    Result<bool> next();

    // The current row:
    bool has(std::size_t column) const;
    std::string text(std::size_t column) const final;
    /// The number in the cell; empty if the cell holds no finite number.
    std::optional<double> number(std::size_t column) const final;
    /// The transformed place of the geometry.
    virtual Result<VectorPlace> place() const = 0;
    /// A problem with the row. @param column name; may be empty.
    virtual Diagnostic problem(const std::string& column, const std::string& message) const = 0;

private:
    struct Expression {
        RowExpression expression;
        bool isRead = true;
        RowExpression::Value value{}; ///< In the current row.
    };
    const Expression* expression(std::size_t column) const;
    Result<bool> evaluate();

    // As has(), text() and number(), for a column of the file.
    virtual bool hasCell(std::size_t column) const = 0;
    virtual std::string cellText(std::size_t column) const = 0;
    virtual std::optional<double> cellNumber(std::size_t column) const = 0;
    /// The number in a text that was made of cells.
    virtual std::optional<double> numberIn(const std::string& text) const = 0;
    // As rewind() and next(), for all rows.
    virtual void restart(const CrsTransform& transform, std::vector<std::size_t> columns) = 0;
    virtual Result<bool> advance() = 0;

    std::optional<RowExpression> _filter;
    std::vector<Expression> _expressions; ///< Columns after those of the file.
};

class TableReader;
class InputFolders;

/// Reads the keys `delimiter`, `decimal`, `comment`, `header_line` and `columns` of an [inventory] or a
/// [wind] record.
TableOptions readTableOptions(TableReader& table);

/// Opens the file of an [inventory], with its `layer`, `filter` and the keys of tables. Null after a problem.
std::unique_ptr<TreeRows> openTreeRows(TableReader& table, const InputFolders& folders);

} // namespace osgTreeWind
