// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/TreeRecord.h>
#include <examples/osgtreewind/output/CommandError.h>

#include <osgTreeWind/base/CsvTable.h>

#include <string>

/// A CSV file with one tree per row. Missing columns and empty cells leave the previous values. Throws
/// CommandError for invalid values.
class TreeTable {
public:
    static TreeTable read(const std::string& path);

    const std::vector<osgTreeWind::CsvTable::Row>& rows() const { return _csv.rows; }

    /// Reads species, dbh_cm, height_m, crown_width_m, open and leaves, and the columns of `info --trees`:
    /// trunk_diameter, height and crown_width in metres.
    void read(const osgTreeWind::CsvTable::Row& row, TreeRecord& tree) const;
    /// The species of the tree in a row. Throws CommandError if it is unknown.
    osgTreeWind::Species species(const osgTreeWind::CsvTable::Row& row, const TreeRecord& tree) const;
    /// Reads the number in a column, from `low` to `high`.
    void read(const osgTreeWind::CsvTable::Row& row, const char* column, double low, double high,
              double& value) const;

    /// File and line of a row.
    std::string placeOf(const osgTreeWind::CsvTable::Row& row) const {
        return _csv.file + ':' + std::to_string(row.line);
    }
    /// Throws an error with the place of the row.
    [[noreturn]] void fail(const osgTreeWind::CsvTable::Row& row, const CommandError& error) const;

    /// Whether the table has a column `id`.
    bool hasIds() const { return _csv.column("id").has_value(); }
    const std::string& id(const osgTreeWind::CsvTable::Row& row) const {
        return row.cells[*_csv.column("id")];
    }

private:
    explicit TreeTable(osgTreeWind::CsvTable csv) : _csv(std::move(csv)) {}
    const std::string* cell(const osgTreeWind::CsvTable::Row& row, const char* column) const;

    osgTreeWind::CsvTable _csv;
};
