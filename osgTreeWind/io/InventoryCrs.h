// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/InventoryColumns.h>

namespace osgTreeWind {

struct ForestReading;

/// How places of an inventory come into the forest's system: from its `crs`, else from what the file says or
/// its columns are called; places without any are the forest's. A forest without one takes that of the file,
/// or for what is no map in metres the UTM zone of the middle.
/// @param rows may be null. @return nothing, and problems, where there is no way.
std::optional<CrsWay> wayOfInventory(TableReader& table, TreeRows* rows, const InventoryColumns& columns,
                                     ForestReading& reading);

/// What a row has, in metres.
Result<double> metresOfRow(const TreeRows& rows, const Measure& measure);

/// Where a row is, by its columns or by itself.
Result<VectorPlace> placeOfRow(const TreeRows& rows, const InventoryColumns& columns, const CrsWay& way);

} // namespace osgTreeWind
