// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/TreeTable.h>

#include <fstream>
#include <iostream>

using namespace osgTreeWind;

std::optional<TreeTable> TreeTable::read(const std::string& path) {
    std::ifstream file(path);
    if (!file) {
        std::cerr << "cannot open " << path << '\n';
        return {};
    }
    Result<CsvTable> csv = readCsvTable(file, path);
    if (!csv.ok()) {
        std::cerr << csv.problems().front().text() << '\n';
        return {};
    }
    return TreeTable(std::move(csv.value()));
}

bool TreeTable::read(const CsvTable::Row& row, OneTree& tree) const {
    double open = tree.open ? 1.0 : 0.0, trunk = 0.01 * tree.diameter;
    const bool right = read(row, "trunk_diameter", 0.001, 20.0, trunk) &&
                       read(row, "height", 0.1, 150.0, tree.height) &&
                       read(row, "crown_width", 0.1, 150.0, tree.crownWidth);
    tree.diameter = 100.0 * trunk;
    const bool alsoRight = read(row, "dbh_cm", 0.1, 2000.0, tree.diameter) &&
                           read(row, "height_m", 0.1, 150.0, tree.height) &&
                           read(row, "crown_width_m", 0.1, 150.0, tree.crownWidth) &&
                           read(row, "leaves", 0.0, 1.0, tree.leaves) && read(row, "open", 0.0, 1.0, open);
    tree.open = open > 0.0;
    if (const std::string* name = cell(row, "species"))
        tree.species = *name;
    return right && alsoRight;
}

bool TreeTable::read(const CsvTable::Row& row, const char* column, double low, double high,
                     double& value) const {
    if (!cell(row, column))
        return true;
    const Result<double> number = _csv.number(row, *_csv.column(column));
    if (!number.ok()) {
        std::cerr << number.problems().front().text() << '\n';
        return false;
    }
    if (number.value() < low || number.value() > high) {
        std::cerr << _csv.file << ':' << row.line << ": " << column << " is not within " << low << " to "
                  << high << '\n';
        return false;
    }
    value = number.value();
    return true;
}

/// Null where there is nothing.
const std::string* TreeTable::cell(const CsvTable::Row& row, const char* column) const {
    const std::optional<std::size_t> found = _csv.column(column);
    return found && !row.cells[*found].empty() ? &row.cells[*found] : nullptr;
}
