// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/TreeRows.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace osgTreeWind {

/// The column of an inventory that has a place in each cell (parsePlace()). Holds the places of all rows. The
/// map program reads the cells with geometries other than a point as WKT.
class PointColumn {
public:
    /// Reads all rows.
    PointColumn(TreeRows& rows, std::size_t column) : _column(column) { read(rows); }

    /// The system that EWKT or EWKB states; empty if none does. A problem if cells state several.
    Result<std::optional<Crs>> crs() const;
    /// Decides which coordinate of the cells is x, and exchanges them where it is the second.
    /// @param isYFirst empty: the usual order of each form. @param isDegrees whether they are longitudes and
    /// latitudes. @return a problem if pairs may have either order.
    Diagnostics order(std::optional<bool> isYFirst, bool isDegrees, const std::string& name);
    /// What order() assumed; may be empty.
    const std::string& note() const { return _note; }
    /// The places; NaN if a row has none.
    std::vector<glm::dvec2> places() const;
    void transform(TreeRows& rows, const CrsTransform& transform);

    /// The place of the current row. @param index of the row, from 0.
    Result<VectorPlace> placeOf(const TreeRows& rows, std::size_t index) const;

private:
    /// Cells to send to the map program.
    struct Batch {
        std::vector<std::size_t> rows;
        std::vector<std::string> texts;
    };
    void read(TreeRows& rows);
    void readBatch(Batch& batch, const CrsTransform& transform);

    std::size_t _column;
    enum class Order : char { Known, Pair, Geometry };
    std::vector<VectorPlace> _places;             ///< By row; NaN if it has none.
    std::vector<Order> _orders;                   ///< What decides on the order of a row's coordinates.
    std::map<std::size_t, std::string> _problems; ///< Of geometries, by row.
    std::map<int, std::string> _srids;            ///< With a cell that states it.
    std::string _pair;                            ///< The first pair.
    bool _hasGeometries = false, _hasBrackets = true;
    bool _mayBeXFirst = true, _mayBeYFirst = true; ///< Whether the pairs can be (longitude, latitude), ...
    bool _isYFirst = false;                        ///< Of geometries.
    std::string _note;
};

} // namespace osgTreeWind
