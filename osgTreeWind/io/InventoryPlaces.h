// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/InventoryColumns.h>

namespace osgTreeWind {

struct ForestReading;

/// Where the rows of an inventory are, in the forest's system. Places come from the system that its `crs`
/// names, else from what the file says or its columns are called; places without any are the forest's. A
/// forest without one takes that of the file, or for what is no map in metres the UTM zone of the middle.
class InventoryPlaces {
public:
    /// @param rows may be null. @return nothing, and problems, where there is no way.
    static std::optional<InventoryPlaces> find(TableReader& table, TreeRows* rows,
                                               const InventoryColumns& columns, ForestReading& reading);

    /// Makes the first row the next one, with what find() was asked about.
    void rewind(TreeRows& rows, InventoryColumns& columns) const;
    /// Where a row is, by its columns or by itself. @param index of the row, from 0.
    Result<VectorPlace> of(const TreeRows& rows, const InventoryColumns& columns, std::size_t index) const;

private:
    CrsWay _way;
    std::vector<glm::dvec2> _there; ///< Of rows whose columns say x and y, brought there; empty: they stay.
};

/// What a row has, in metres.
Result<double> metresOfRow(const TreeRows& rows, const Measure& measure);
/// The same of the number that was read from the row's cell.
Result<double> metresOfRow(const TreeRows& rows, const Measure& measure, const Result<double>& number);

} // namespace osgTreeWind
