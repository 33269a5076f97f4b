// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/InventoryColumns.h>

namespace osgTreeWind {

class SceneMap;

/// Finds the places of an inventory's rows in the forest's CRS. The source CRS is the key `crs`, or else that
/// of the file or implied by its column names, or else the forest's. If the forest has no CRS, it is set to
/// the source CRS, or to the UTM zone of the rows' centre if the source CRS is not projected in metres.
class InventoryPlaces {
public:
    /// @param rows may be null. @return empty after a problem.
    static std::optional<InventoryPlaces> find(TableReader& table, TreeRows* rows,
                                               const InventoryColumns& columns, SceneMap& map);

    /// Restarts before the first row.
    void rewind(TreeRows& rows, InventoryColumns& columns) const;
    /// The place of the current row. @param index of the row, from 0.
    Result<VectorPlace> placeOf(const TreeRows& rows, const InventoryColumns& columns,
                                std::size_t index) const;

private:
    CrsTransform _transform;
    std::vector<glm::dvec2> _transformed; ///< Places in columns, transformed; empty for the identity.
};

/// A measure of the current row in metres.
Result<double> readMetres(const TreeRows& rows, const MeasureColumn& measure);
/// Converts a number that was read from the row.
Result<double> readMetres(const TreeRows& rows, const MeasureColumn& measure,
                          const std::optional<double>& number);

} // namespace osgTreeWind
