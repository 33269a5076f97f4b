// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/base/Range.h>
#include <osgTreeWind/io/TreeRows.h>

#include <array>
#include <utility>

namespace osgTreeWind {

/// A number that a row may hold.
struct Measure {
    const char* key;
    Range range;                         ///< Metres.
    std::optional<std::size_t> column{}; ///< Empty: rows do not have it.
    double unit = 1.0;                   ///< Metres.
};

/// Units of length and what they are in metres.
const std::vector<std::pair<std::string, double>>& lengthUnits();
/// A number with or without a unit behind it; without one it is metres.
std::optional<double> metresOf(const std::string& text);

/// Which columns say what of a tree: as [inventory] has it, else as their format is known to.
class InventoryColumns {
public:
    /// @param rows null: only the keys are looked at.
    void read(TableReader& table, const TreeRows* rows);
    /// Whether all is there that trees need but their species.
    bool complete() const { return _complete; }
    /// Whether places are in columns, `x` and `y` or `point`, and not those of the rows themselves.
    bool hasXY() const { return x.column || point; }
    /// All columns that are read.
    std::vector<std::size_t> all();
    /// Whether places are longitudes and latitudes, as the names of `x` and `y` say it, or those of a
    /// `point`.
    bool areDegrees(const TreeRows& rows) const;

    Measure x{"x", worldCoordinates}, y{"y", worldCoordinates}, z{"z", worldCoordinates};
    Measure height, trunkDiameter, circumference, crownWidth;
    std::optional<std::size_t> point; ///< A place in one cell: "48.88, 2.30" or "POINT (2.30 48.88)".
    std::optional<std::size_t> id;
    std::vector<std::size_t> species; ///< The first whose name is known counts.

    InventoryColumns();

private:
    std::array<Measure*, 7> measures() {
        return {&x, &y, &z, &height, &trunkDiameter, &circumference, &crownWidth};
    }
    std::optional<std::size_t> find(TableReader& columns, const std::string& key, const TreeRows* rows);
    void takeKnown(const TreeRows& rows);
    void readUnits(TableReader& units);

    bool _complete = true;
};

} // namespace osgTreeWind
