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
std::string countText(std::string_view key, std::size_t count) {
    std::string name(key);
    std::replace(name.begin(), name.end(), '_', ' ');
    return name + " of " + std::to_string(count);
}

constexpr double maxRecordShare = 1.5; // related species and new records

bool isPossible(double metres, float record) {
    return !(record > 0.0f) || metres <= maxRecordShare * static_cast<double>(record);
}

std::string recordText(const MeasureColumn& measure, float record) {
    return "expected at most " + numberText(maxRecordShare * static_cast<double>(record)) +
           " metres, 1.5 times species." + (std::string(measure.key) == "height" ? "height" : "crown") +
           ".largest";
}

} // namespace

bool InventorySizes::isMissingMark(double number) const {
    return number == 0.0 || isMissing(number) || std::count(missing.begin(), missing.end(), number) > 0;
}

float InventorySizes::checked(const MeasureColumn& measure, const Result<double>& metres) {
    Column& column = _columns[measure.key];
    if (metres) {
        ++column.used;
        return static_cast<float>(metres.value());
    }
    if (column.impossible++ == 0)
        column.first = metres.problems().front();
    return 0.0f;
}

float InventorySizes::read(const TreeRows& row, const MeasureColumn& measure, float record) {
    if (!measure.column || !row.has(*measure.column))
        return 0.0f;
    const std::optional<double> number = row.number(*measure.column);
    if (number ? isMissingMark(*number) : isMissing(row.text(*measure.column))) {
        ++_columns[measure.key].marked;
        return 0.0f;
    }
    Result<double> metres = readMetres(row, measure, number);
    if (metres && !isPossible(metres.value(), record))
        metres = row.problem(row.nameOf(*measure.column),
                             recordText(measure, record) + ", found " + inQuotes(row.text(*measure.column)));
    return checked(measure, metres);
}

float InventorySizes::readGeometry(const TreeRows& row, const MeasureColumn& measure, const char* what,
                                   double metres, float record) {
    Result<double> checkedMetres = metres;
    if (!measure.range.contains(metres))
        checkedMetres = row.problem("", std::string("expected ") + what + " of " + measure.range.text() +
                                            " metres, found " + numberText(metres));
    else if (!isPossible(metres, record))
        checkedMetres = row.problem("", recordText(measure, record) + ", found " + what + " of " +
                                            numberText(metres) + " m");
    return checked(measure, checkedMetres);
}

Diagnostics InventorySizes::problems() const {
    constexpr std::size_t minCount = 3; // fewer are likely to be typing errors
    Diagnostics problems;
    for (const auto& [key, column] : _columns)
        if (column.impossible >= minCount && column.impossible > column.used) {
            Diagnostic problem = column.first;
            problem.message += "; the same applies to " + std::to_string(column.impossible) + " of " +
                               std::to_string(column.impossible + column.used) +
                               " rows: set their unit with inventory.units." + std::string(key) +
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
