// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/TreeTable.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>

using namespace osgTreeWind;

TreeTable TreeTable::read(const std::string& path) {
    Result<std::ifstream> file = openInput(path);
    return TreeTable(
        valueOrThrow(file ? readCsvTable(file.value(), path) : Result<CsvTable>(file.problems())));
}

void TreeTable::read(const CsvTable::Row& row, TreeRecord& tree) const {
    double open = tree.open ? 1.0 : 0.0, trunk = 0.01 * tree.diameter;
    read(row, "trunk_diameter", 0.001, 20.0, trunk);
    read(row, "height", 0.1, 150.0, tree.height);
    read(row, "crown_width", 0.1, 150.0, tree.crownWidth);
    tree.diameter = 100.0 * trunk;
    read(row, "dbh_cm", 0.1, 2000.0, tree.diameter);
    read(row, "height_m", 0.1, 150.0, tree.height);
    read(row, "crown_width_m", 0.1, 150.0, tree.crownWidth);
    read(row, "leaves", 0.0, 1.0, tree.leaves);
    read(row, "open", 0.0, 1.0, open);
    tree.open = open > 0.0;
    if (const std::string* name = cell(row, "species"))
        tree.species = *name;
}

Species TreeTable::species(const CsvTable::Row& row, const TreeRecord& tree) const {
    try {
        return speciesByName(tree.species);
    } catch (const CommandError& error) {
        fail(row, error);
    }
}

void TreeTable::read(const CsvTable::Row& row, const char* column, double low, double high,
                     double& value) const {
    if (!cell(row, column))
        return;
    const double number = valueOrThrow(_csv.number(row, *_csv.column(column)));
    if (number < low || number > high) {
        const std::string range = "a number from " + numberText(low) + " to " + numberText(high);
        fail(row, {BadInput, column + (": " + expectedFound(range, *cell(row, column)))});
    }
    value = number;
}

void TreeTable::fail(const CsvTable::Row& row, const CommandError& error) const {
    throw CommandError{error.exitCode, placeOf(row) + ": " + error.message};
}

/// Null if the column is missing or the cell is empty.
const std::string* TreeTable::cell(const CsvTable::Row& row, const char* column) const {
    const std::optional<std::size_t> found = _csv.column(column);
    return found && !row.cells[*found].empty() ? &row.cells[*found] : nullptr;
}
