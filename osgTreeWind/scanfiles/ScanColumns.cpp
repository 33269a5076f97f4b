// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanColumns.h>

#include <osgTreeWind/base/Text.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// Column names of a program, in the order of ScanColumns::Column.
struct ColumnNames {
    const char* format;
    const char* names[ScanColumns::count];
};

constexpr ColumnNames knownNames[] = {{"SimpleForest",
                                       {"ID", "parentID", "radius", "startX", "startY", "startZ", "endX",
                                        "endY", "endZ", "axisX", "axisY", "axisZ", "length"}},
                                      {"aRchi",
                                       {"cyl_ID", "parent_ID", "radius_cyl", "startX", "startY", "startZ",
                                        "endX", "endY", "endZ", "axisX", "axisY", "axisZ", "length"}},
                                      {"rTwig",
                                       {"id", "parent", "radius", "start_x", "start_y", "start_z", "end_x",
                                        "end_y", "end_z", "axis_x", "axis_y", "axis_z", "length"}},
                                      {"rTwig",
                                       {"extension", "parent", "radius", "start.x", "start.y", "start.z",
                                        "end.x", "end.y", "end.z", "axis.x", "axis.y", "axis.z", "length"}}};
constexpr const ColumnNames& treeQsmNames = knownNames[3];

/// A name in the form in which names are compared.
std::string normalized(std::string_view name) {
    std::string letters = lower(std::string(name));
    letters.erase(std::remove_if(letters.begin(), letters.end(), [](char c) { return c == '.' || c == '_'; }),
                  letters.end());
    return letters;
}

/// Looks up the column names of a table.
class TableHeader {
public:
    explicit TableHeader(const CsvTable& table) : _table(table) {
        for (const std::string& name : table.columns)
            _names.push_back(normalized(name));
        for (const ColumnNames& writer : knownNames)
            if (usesNamesOf(writer))
                _candidates.push_back(&writer);
        _isKnownFormat = !_candidates.empty();
        if (!_isKnownFormat)
            for (const ColumnNames& writer : knownNames)
                _candidates.push_back(&writer);
    }

    std::string format() const { return _isKnownFormat ? _candidates.front()->format : "table"; }

    std::optional<std::size_t> find(std::size_t column) const {
        for (const ColumnNames* writer : _candidates)
            if (const auto found = find(*writer, column))
                return found;
        return std::nullopt;
    }

    /// Number of the columns in [first, last) that the table has.
    std::size_t count(std::size_t first, std::size_t last) const {
        std::size_t known = 0;
        for (std::size_t column = first; column < last; ++column)
            known += find(column).has_value();
        return known;
    }

    Diagnostic missingColumn(std::size_t column) const {
        const std::string name = _candidates.front()->names[column];
        std::string others, seen = ' ' + normalized(name) + ' ';
        for (const ColumnNames* writer : _candidates) {
            const std::string other = normalized(writer->names[column]) + ' ';
            if (seen.find(' ' + other) != std::string::npos)
                continue;
            others += std::string(" or ") + writer->names[column];
            seen += other;
        }
        return {_table.file, _table.headerLine, 0, name, "expected a column of this name" + others};
    }

private:
    std::optional<std::size_t> find(const ColumnNames& writer, std::size_t column) const {
        const auto found = std::find(_names.begin(), _names.end(), normalized(writer.names[column]));
        if (found == _names.end())
            return std::nullopt;
        return static_cast<std::size_t>(found - _names.begin());
    }

    /// Whether all known columns of the table have the names of this program.
    bool usesNamesOf(const ColumnNames& writer) const {
        for (std::size_t column = 0; column < ScanColumns::count; ++column)
            for (const ColumnNames& other : knownNames)
                if (find(other, column) && !find(writer, column))
                    return false;
        return true;
    }

    const CsvTable& _table;
    std::vector<std::string> _names;
    std::vector<const ColumnNames*> _candidates; ///< Matching programs, or all of them.
    bool _isKnownFormat = false;
};

} // namespace

bool ScanColumns::matches(std::string_view names) {
    return normalized(names).find(normalized(knownNames[0].names[start])) != std::string::npos;
}

Result<ScanColumns> ScanColumns::find(const CsvTable& table) {
    const TableHeader header(table);
    ScanColumns columns;
    columns.format = header.format();
    const std::size_t ends = header.count(end, axis), axes = header.count(axis, length);
    const bool hasAxis = axes == 3 && header.find(length);
    columns.hasEnds = ends == 3 || (!hasAxis && (ends > 0 || axes == 0));
    for (std::size_t column = 0; column < count; ++column) {
        const bool ofEnds = column >= end && column < axis, ofAxis = column >= axis;
        if ((ofEnds && !columns.hasEnds) || (ofAxis && columns.hasEnds))
            continue;
        const auto found = header.find(column);
        if (!found)
            return header.missingColumn(column);
        columns.at[column] = *found;
    }
    columns.idsAreExtensions = normalized(table.columns[columns.at[id]]) == treeQsmNames.names[id];
    return columns;
}

} // namespace osgTreeWind
