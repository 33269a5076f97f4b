// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/options/OneTree.h>

#include <osgTreeWind/base/CsvTable.h>

#include <string>

/// A CSV file of trees, one a row. What a row or the file does not say is as it was before. What is not as it
/// has to be ends the command.
class TreeTable {
public:
    static TreeTable read(const std::string& path);

    const std::vector<osgTreeWind::CsvTable::Row>& rows() const { return _csv.rows; }

    /// species, dbh_cm, height_m, crown_width_m, open and leaves, or in metres as `info --trees` writes them:
    /// trunk_diameter, height, crown_width.
    void read(const osgTreeWind::CsvTable::Row& row, OneTree& tree) const;
    /// The species that a tree of that row is said to be. One that is unknown ends the command.
    osgTreeWind::Species species(const osgTreeWind::CsvTable::Row& row, const OneTree& tree) const;
    /// The number in a column.
    void read(const osgTreeWind::CsvTable::Row& row, const char* column, double low, double high,
              double& value) const;

    /// Whether trees have an id, and that of one.
    bool hasIds() const { return _csv.column("id").has_value(); }
    const std::string& id(const osgTreeWind::CsvTable::Row& row) const {
        return row.cells[*_csv.column("id")];
    }

private:
    explicit TreeTable(osgTreeWind::CsvTable csv) : _csv(std::move(csv)) {}
    const std::string* cell(const osgTreeWind::CsvTable::Row& row, const char* column) const;

    osgTreeWind::CsvTable _csv;
};
