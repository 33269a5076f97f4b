// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanColumns.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Text.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

using Names = std::vector<std::string>;
using Columns = std::array<std::optional<std::size_t>, ScanColumns::count>;

/// Names of a column, in order of preference; % stands for x, y and z.
struct ColumnNames {
    ScanColumns::Column column;
    Names names;
};

const std::vector<ColumnNames>& knownNames() {
    static const std::vector<ColumnNames> names = {
        {ScanColumns::id,
         {"ID", "cyl_ID", "node_ID", "extension", "point_ID", "vertex_ID", "segment_ID", "cylinder_ID",
          "node", "sample", "index", "n"}},
        {ScanColumns::parent,
         {"parent_ID", "parent", "parent_node", "parent_node_ID", "parent_index", "PID", "p"}},
        {ScanColumns::radius, {"radius", "radius_cyl", "node_radius", "rad", "r"}},
        {ScanColumns::diameter, {"diameter", "diam", "d"}},
        {ScanColumns::length, {"length", "len", "l"}},
        {ScanColumns::start, {"start%", "%_start", "s%", "%1", "base%", "from%"}},
        {ScanColumns::end, {"end%", "%_end", "e%", "%2", "top%", "tip%", "to%"}},
        {ScanColumns::axis, {"axis%", "a%", "direction%", "dir%"}},
        {ScanColumns::place, {"%", "pos%", "position%", "node%", "coord%"}}};
    return names;
}

/// A name in the form in which names are compared; metres are the unit of all columns.
std::string normalized(std::string_view name) {
    std::string letters = lower(std::string(trimmed(name)));
    for (const std::string_view unit : {"(m)", "[m]"})
        if (letters.size() > unit.size() && letters.substr(letters.size() - unit.size()) == unit)
            letters.resize(letters.size() - unit.size());
    const auto isIgnored = [](char c) { return c == '.' || c == '_' || c == ' ' || c == '-' || c == '"'; };
    letters.erase(std::remove_if(letters.begin(), letters.end(), isIgnored), letters.end());
    return letters;
}

/// The names of a column for one axis of a vector, 0 to 2.
Names namesOf(const ColumnNames& known, std::size_t axis) {
    Names names = known.names;
    for (std::string& name : names)
        if (const std::size_t at = name.find('%'); at != std::string::npos)
            name[at] = static_cast<char>('X' + axis);
    return names;
}

Columns columnsOf(const Names& header) {
    Columns columns;
    Names found;
    for (const std::string& name : header)
        found.push_back(normalized(name));
    for (const ColumnNames& known : knownNames())
        for (std::size_t axis = 0; axis < (known.column >= ScanColumns::start ? 3 : 1); ++axis)
            for (const std::string& name : namesOf(known, axis))
                if (auto& column = columns[known.column + axis]; !column)
                    if (const auto at = std::find(found.begin(), found.end(), normalized(name));
                        at != found.end())
                        column = static_cast<std::size_t>(at - found.begin());
    return columns;
}

std::size_t countMissing(const Columns& columns, std::initializer_list<ScanColumns::Column> vectors) {
    std::size_t missing = 0;
    for (const ScanColumns::Column vector : vectors)
        for (std::size_t axis = 0; axis < 3; ++axis)
            missing += !columns[vector + axis];
    return missing;
}

/// The program that gives its columns these names.
std::string formatOf(const CsvTable& table, const ScanColumns& columns) {
    if (columns.kind == ScanColumns::place)
        return "table of points";
    const auto name = [&](ScanColumns::Column column) {
        return columns.at[column] ? normalized(table.columns[*columns.at[column]]) : std::string();
    };
    const std::string names =
        name(ScanColumns::id) + ' ' + name(ScanColumns::parent) + ' ' + name(ScanColumns::radius);
    if (name(ScanColumns::start) != "startx")
        return "table";
    return names == "id parentid radius"                                       ? "SimpleForest"
           : names == "cylid parentid radiuscyl"                               ? "aRchi"
           : names == "id parent radius" || names == "extension parent radius" ? "rTwig"
                                                                               : "table";
}

Diagnostic missingColumn(const CsvTable& table, std::size_t column) {
    const auto known = std::find_if(knownNames().rbegin(), knownNames().rend(),
                                    [&](const ColumnNames& names) { return names.column <= column; });
    return {table.file,
            table.headerLine,
            0,
            {},
            "expected a column with one of the names " + joined(namesOf(*known, column - known->column)) +
                "; found " + joined(table.columns)};
}

Columns columnsOf(std::string_view names) {
    Names header;
    while (!(names = trimmed(names)).empty()) {
        const std::size_t end = std::min(names.find_first_of(" ;"), names.size());
        header.emplace_back(names.substr(0, end));
        names.remove_prefix(std::min(end + 1, names.size()));
    }
    return columnsOf(header);
}

} // namespace

bool ScanColumns::havePlaces(std::string_view names) {
    const Columns columns = columnsOf(names);
    return columns[start] || columns[place];
}

bool ScanColumns::haveRadii(std::string_view names) {
    const Columns columns = columnsOf(names);
    return columns[radius] || columns[diameter];
}

Result<ScanColumns> ScanColumns::find(const CsvTable& table) {
    ScanColumns columns;
    columns.at = columnsOf(table.columns);
    const std::size_t ends = countMissing(columns.at, {start, end}),
                      axes = countMissing(columns.at, {start, axis}) + !columns.at[length],
                      points = countMissing(columns.at, {place});
    columns.kind = points < std::min(ends, axes) ? place : axes < ends ? axis : end;
    std::vector<std::size_t> needed;
    if (!columns.at[diameter])
        needed.push_back(radius);
    if (columns.kind == place)
        needed.push_back(parent);
    for (const std::size_t vector : {columns.kind == place ? place : start, columns.kind})
        for (std::size_t axis = 0; axis < 3; ++axis)
            needed.push_back(vector + axis);
    if (columns.kind == axis)
        needed.push_back(length);
    for (const std::size_t column : needed)
        if (!columns.at[column])
            return missingColumn(table, column);
    columns.format = formatOf(table, columns);
    columns.idsAreExtensions = columns.at[id] && normalized(table.columns[*columns.at[id]]) == "extension";
    return columns;
}

} // namespace osgTreeWind
