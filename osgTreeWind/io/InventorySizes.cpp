// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/InventorySizes.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/io/InventoryPlaces.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// "trunk diameter of 3".
std::string countText(std::string key, std::size_t count) {
    std::replace(key.begin(), key.end(), '_', ' ');
    return key + " of " + std::to_string(count);
}

} // namespace

bool InventorySizes::isMissingMark(double number) const {
    return number == 0.0 || isMissing(number) || std::count(missing.begin(), missing.end(), number) > 0;
}

float InventorySizes::read(const TreeRows& row, const MeasureColumn& measure) {
    if (!measure.column || !row.has(*measure.column))
        return 0.0f;
    Column& column = _columns[measure.key];
    const Result<double> number = row.number(*measure.column);
    if (number ? isMissingMark(number.value()) : isMissing(row.text(*measure.column))) {
        ++column.marked;
        return 0.0f;
    }
    const Result<double> metres = readMetres(row, measure, number);
    if (metres) {
        ++column.used;
        return static_cast<float>(metres.value());
    }
    if (column.impossible++ == 0)
        column.first = metres.problems().front();
    return 0.0f;
}

float InventorySizes::readOutline(const TreeRows& row, const MeasureColumn& measure, double width) {
    if (measure.range.contains(width))
        return static_cast<float>(width);
    if (_columns[measure.key].impossible++ == 0)
        _columns[measure.key].first =
            row.problem("", "expected the outline of a crown, " + measure.range.text() +
                                " metres wide, found " + numberText(width));
    return 0.0f;
}

Diagnostics InventorySizes::problems() const {
    constexpr std::size_t minCount = 3; // fewer are likely to be typing errors
    Diagnostics problems;
    for (const auto& [key, column] : _columns)
        if (column.impossible >= minCount && column.impossible > column.used) {
            Diagnostic problem = column.first;
            problem.message += "; the same applies to " + std::to_string(column.impossible) + " of " +
                               std::to_string(column.impossible + column.used) +
                               " rows: set their unit with inventory.units." + key +
                               ", or the numbers that mean \"not measured\" with inventory.missing";
            problems.push_back(problem);
        }
    return problems;
}

std::vector<std::string> InventorySizes::notes() const {
    std::vector<std::string> notes, marked, impossible;
    const Diagnostic* first = nullptr;
    for (const auto& [key, column] : _columns) {
        if (column.marked > 0)
            marked.push_back(countText(key, column.marked));
        if (column.impossible > 0)
            impossible.push_back(countText(key, column.impossible));
        if (column.impossible > 0 && !first)
            first = &column.first;
    }
    if (!marked.empty())
        notes.push_back("0 and markers such as -99 count as not measured: " + joined(marked) + " rows");
    if (first)
        notes.push_back("impossible sizes count as not measured: " + joined(impossible) +
                        " rows, the first: " + first->text());
    return notes;
}

} // namespace osgTreeWind
