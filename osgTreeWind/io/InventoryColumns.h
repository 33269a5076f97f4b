// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/base/SizeText.h>
#include <osgTreeWind/io/TreeRows.h>

#include <array>
#include <utility>

namespace osgTreeWind {

/// A length that rows may contain, with its key, valid range and unit.
struct MeasureColumn {
    const char* key;
    Range range;                         ///< Metres.
    std::optional<std::size_t> column{}; ///< Empty if there is no such column.
    double unit = 1.0;                   ///< Metres per unit.
    SizeKind kind = SizeKind::Height;    ///< Of sizes.
};

/// Maps columns of an inventory to properties of trees, by its [inventory] table or its known format.
class InventoryColumns {
public:
    /// @param rows null: only validate the keys.
    void read(TableReader& table, TreeRows* rows);
    /// Whether all required columns and all named ones were found. Only valid with rows.
    bool isComplete() const { return _complete; }
    /// Whether places are in columns (`x` and `y`, or `point`) instead of the rows' geometry.
    bool hasPlaceColumns() const { return x.column || point; }
    /// All columns to read.
    std::vector<std::size_t> allColumns();
    /// Whether `x` and `y` are longitudes and latitudes by their names.
    bool areInDegrees(const TreeRows& rows) const;

    MeasureColumn x{"x", worldCoordinates}, y{"y", worldCoordinates}, z{"z", worldCoordinates};
    MeasureColumn height, trunkDiameter, circumference, crownWidth;
    std::optional<std::size_t> point; ///< Places such as "48.88, 2.30" or "POINT (2.30 48.88)".
    std::optional<std::size_t> id;
    std::vector<std::size_t> species;    ///< The first with a known name counts.
    std::optional<std::size_t> leafType; ///< OpenStreetMap's `leaf_type`.

    InventoryColumns();

private:
    std::array<MeasureColumn*, 7> measures() {
        return {&x, &y, &z, &height, &trunkDiameter, &circumference, &crownWidth};
    }
    std::optional<std::size_t> find(TableReader& columns, const std::string& key, TreeRows* rows);
    void useKnownColumns(const TreeRows& rows);
    void readUnits(TableReader& table, const TreeRows* rows);

    bool _complete = true;
};

} // namespace osgTreeWind
