// SPDX-License-Identifier: MIT
#include <osgTreeWind/scanfiles/ScanColumns.h>

#include <osgTreeWind/base/Text.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

/// The names that a program gives to columns, in the order of ScanColumns::Column.
struct Writer {
    const char* format;
    const char* names[ScanColumns::count];
};

constexpr Writer writers[] = {{"SimpleForest",
                               {"ID", "parentID", "radius", "startX", "startY", "startZ", "endX", "endY",
                                "endZ", "axisX", "axisY", "axisZ", "length"}},
                              {"aRchi",
                               {"cyl_ID", "parent_ID", "radius_cyl", "startX", "startY", "startZ", "endX",
                                "endY", "endZ", "axisX", "axisY", "axisZ", "length"}},
                              {"rTwig",
                               {"id", "parent", "radius", "start_x", "start_y", "start_z", "end_x", "end_y",
                                "end_z", "axis_x", "axis_y", "axis_z", "length"}},
                              {"rTwig",
                               {"extension", "parent", "radius", "start.x", "start.y", "start.z", "end.x",
                                "end.y", "end.z", "axis.x", "axis.y", "axis.z", "length"}}};
constexpr const Writer& extensions = writers[3];

/// What is compared of a name.
std::string plain(std::string_view name) {
    std::string letters = lower(std::string(name));
    letters.erase(std::remove_if(letters.begin(), letters.end(), [](char c) { return c == '.' || c == '_'; }),
                  letters.end());
    return letters;
}

/// The names of a table, looked up.
class TableHeader {
public:
    explicit TableHeader(const CsvTable& table) : _table(table) {
        for (const std::string& name : table.columns)
            _names.push_back(plain(name));
        for (const Writer& writer : writers)
            if (bearsItsNames(writer))
                _writers.push_back(&writer);
        _knowsWriter = !_writers.empty();
        if (!_knowsWriter)
            for (const Writer& writer : writers)
                _writers.push_back(&writer);
    }

    std::string format() const { return _knowsWriter ? _writers.front()->format : "table"; }

    /// Empty where there is none.
    std::optional<std::size_t> find(std::size_t column) const {
        for (const Writer* writer : _writers)
            if (const auto found = find(*writer, column))
                return found;
        return std::nullopt;
    }

    /// How many of those from `first` to before `last` there are.
    std::size_t count(std::size_t first, std::size_t last) const {
        std::size_t known = 0;
        for (std::size_t column = first; column < last; ++column)
            known += find(column).has_value();
        return known;
    }

    Diagnostic problemOf(std::size_t column) const {
        const std::string name = _writers.front()->names[column];
        std::string others, seen = ' ' + plain(name) + ' ';
        for (const Writer* writer : _writers) {
            const std::string other = plain(writer->names[column]) + ' ';
            if (seen.find(' ' + other) != std::string::npos)
                continue;
            others += std::string(" or ") + writer->names[column];
            seen += other;
        }
        return {_table.file, _table.headerLine, 0, name, "expected a column of this name" + others};
    }

private:
    std::optional<std::size_t> find(const Writer& writer, std::size_t column) const {
        const auto found = std::find(_names.begin(), _names.end(), plain(writer.names[column]));
        if (found == _names.end())
            return std::nullopt;
        return static_cast<std::size_t>(found - _names.begin());
    }

    /// Whether it has a name for each of the columns that any writer has.
    bool bearsItsNames(const Writer& writer) const {
        for (std::size_t column = 0; column < ScanColumns::count; ++column)
            for (const Writer& other : writers)
                if (find(other, column) && !find(writer, column))
                    return false;
        return true;
    }

    const CsvTable& _table;
    std::vector<std::string> _names;
    std::vector<const Writer*> _writers; ///< Who may have named the columns; all where nobody did.
    bool _knowsWriter = false;
};

} // namespace

bool ScanColumns::knows(std::string_view names) {
    return plain(names).find(plain(writers[0].names[start])) != std::string::npos;
}

Result<ScanColumns> ScanColumns::of(const CsvTable& table) {
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
            return header.problemOf(column);
        columns.at[column] = *found;
    }
    columns.idsAreExtensions = plain(table.columns[columns.at[id]]) == extensions.names[id];
    return columns;
}

} // namespace osgTreeWind
