// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/DocumentTrees.h>
#include <osgTreeWind/io/InventoryColumns.h>
#include <osgTreeWind/io/PointColumn.h>

namespace osgTreeWind {

class SceneMap;

/// Finds the places of an inventory's rows in the forest's CRS. The source CRS is the key `crs`, or else that
/// of the file or implied by its cells or column names, or else the forest's. If the forest has no CRS, it is
/// set to the source CRS, or to the UTM zone of the rows' centre if the source CRS is not projected in
/// metres.
class InventoryPlaces {
public:
    /// @param rows may be null. @return empty after a problem.
    static std::optional<InventoryPlaces> find(TableReader& table, TreeRows* rows,
                                               const InventoryColumns& columns, SceneMap& map);

    /// Of places in degrees, unless they are in x and y.
    const std::optional<ExchangedPlace>& exchanged() const { return _exchanged; }
    /// Restarts before the first row.
    void rewind(TreeRows& rows, InventoryColumns& columns) const;
    /// The place of the current row. Its z is NaN if it stands for none, such as -9999.
    /// @param index of the row, from 0.
    Result<VectorPlace> placeOf(const TreeRows& rows, const InventoryColumns& columns,
                                std::size_t index) const;

private:
    CrsTransform _transform;
    bool _isDegrees = false;              ///< Whether the source CRS is in degrees.
    std::vector<glm::dvec2> _transformed; ///< Places in x and y, transformed; empty for the identity.
    std::optional<PointColumn> _points;   ///< Transformed.
    std::optional<ExchangedPlace> _exchanged;
};

/// A measure of the current row in metres.
/// @param number read from the row.
Result<double> readMetres(const TreeRows& rows, const MeasureColumn& measure,
                          const std::optional<double>& number);

} // namespace osgTreeWind
