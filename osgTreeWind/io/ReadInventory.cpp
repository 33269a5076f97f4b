// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/model/Random.h>

#include <glm/gtc/constants.hpp>

namespace osgTreeWind {

namespace {

/// Of what a tree says.
const Range& rangeOf(const std::string& key) {
    return fieldAt(fieldsOf<TreePlacement>(), key).range;
}

/// A number that a column may hold.
struct Measure {
    const char* key;
    Range range;                         ///< Metres.
    std::optional<std::size_t> column{}; ///< Empty: the table does not have it.
    double unit = 1.0;                   ///< Metres.
};

/// Turns the rows of one table into trees. Problems with a row name the table's file and line.
class InventoryReader {
public:
    InventoryReader(TableReader& table, ForestReading& reading) : _table(table), _reading(reading) {}

    void read() {
        char delimiter = ',';
        _table.readChoice<char>("delimiter", delimiter, {{",", ','}, {";", ';'}, {"\t", '\t'}, {"|", '|'}});
        std::uint32_t seed = _reading.seed;
        _table.read("seed", seed);
        _table.read("open_grown", _openGrown);
        _leaves = _reading.leaves;
        _table.read("leaves", _leaves, rangeOf("leaves"));
        readDefaultSpecies();
        _complete &= readCsv(delimiter);
        readColumns();
        _table.table("units", [&](TableReader& units) { readUnits(units); });
        if (!_complete || !_reading.roomFor(_csv.rows.size(), _table, "file"))
            return;

        Random random(seed);
        for (const CsvTable::Row& row : _csv.rows)
            readRow(row, random);
        noteUnmatched();
        noteRepeated();
    }

private:
    void readDefaultSpecies() {
        if (_table.read("default_species", _defaultName)) {
            _default = _reading.speciesOrBuiltIn(_defaultName);
            if (!_default) {
                _table.problem("default_species", "no species " + inQuotes(_defaultName));
                _complete = false;
            }
        } else if (_reading.declaredSpecies == 1)
            _default = 0;
    }

    bool readCsv(char delimiter) {
        auto file = _reading.open(_table, "file");
        if (!file)
            return false;
        auto csv = readCsvTable(file->stream, file->path, delimiter);
        if (!csv.ok()) {
            for (const Diagnostic& problem : csv.problems())
                _reading.log.add(problem);
            return false;
        }
        _csv = std::move(csv.value());
        if (_csv.rows.empty())
            _reading.log.add({_csv.file, 1, 0, "", "an inventory without trees: no row below the header"});
        return !_csv.rows.empty();
    }

    void readColumns() {
        if (!_table.has("columns")) {
            _complete = _table.missing("columns");
            return;
        }
        _table.table("columns", [&](TableReader& columns) {
            for (Measure* measure : _measures)
                measure->column = readColumn(columns, measure->key);
            _id = readColumn(columns, "id");
            _species = readColumn(columns, "species");
            for (const Measure* needed : {&_x, &_y})
                if (!needed->column)
                    _complete = columns.missing(needed->key);
        });
        if (!_species && !_default && _defaultName.empty()) {
            _table.problem("columns", "expected a species column, or default_species beside columns");
            _complete = false;
        }
    }

    std::optional<std::size_t> readColumn(TableReader& columns, const std::string& key) {
        std::string name;
        if (!columns.read(key, name))
            return std::nullopt;
        const auto index = _csv.column(name);
        if (!index && !_csv.columns.empty()) {
            columns.problem(key, "no column " + inQuotes(name) + " in " + _csv.file +
                                     "; it has: " + joined(_csv.columns));
            _complete = false;
        }
        return index;
    }

    void readUnits(TableReader& units) {
        for (Measure* measure : _measures)
            units.readChoice<double>(
                measure->key, measure->unit,
                {{"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"ft", 0.3048}, {"in", 0.0254}});
    }

    void readRow(const CsvTable::Row& row, Random& random) {
        TreePlacement tree;
        tree.species = rowSpecies(row);
        tree.position = {number(row, _x, true), number(row, _y, true), number(row, _z, false)};
        tree.size.height = static_cast<float>(number(row, _height, false));
        tree.size.trunkDiameter = static_cast<float>(number(row, _trunkDiameter, false));
        tree.size.crownWidth = static_cast<float>(number(row, _crownWidth, false));
        tree.openGrown = _openGrown;
        tree.leaves = _leaves;
        tree.heading = random.uniform() * glm::two_pi<float>();
        tree.seed = static_cast<std::uint32_t>(random.next());
        tree.name = rowName(row);
        _reading.forest.trees.push_back(tree);
    }

    /// Metres; 0 when the table does not say and need not.
    double number(const CsvTable::Row& row, const Measure& measure, bool needed) {
        if (!measure.column || (!needed && row.cells[*measure.column].empty()))
            return 0.0;
        const auto number = _csv.number(row, *measure.column);
        if (!number.ok()) {
            _reading.log.add(number.problems().front());
            return 0.0;
        }
        const double metres = number.value() * measure.unit;
        if (!measure.range.contains(metres))
            _reading.log.add({_csv.file, row.line, 0, _csv.columns[*measure.column],
                              "expected " + measure.range.text() + " metres, found " +
                                  inQuotes(row.cells[*measure.column])});
        return metres;
    }

    std::size_t rowSpecies(const CsvTable::Row& row) {
        if (!_species)
            return *_default;
        const std::string& name = row.cells[*_species];
        if (const auto index = _reading.speciesOrBuiltIn(name))
            return *index;
        if (_unmatched[name]++ == 0 && !_default)
            _reading.log.add({_csv.file, row.line, 0, _csv.columns[*_species],
                              "no species " + inQuotes(name) + ", and no default_species"});
        return _default.value_or(0);
    }

    /// Empty where it has none of its own.
    std::string rowName(const CsvTable::Row& row) {
        std::string name = _id ? row.cells[*_id] : std::string();
        if (name.empty() || _reading.treeNames.insert(name).second)
            return name;
        ++_repeated[name];
        return {};
    }

    void noteRepeated() {
        if (_repeated.empty())
            return;
        constexpr std::size_t mostNamed = 10;
        std::vector<std::string> names;
        std::size_t trees = 0;
        for (const auto& [name, rows] : _repeated) {
            trees += rows;
            if (names.size() < mostNamed)
                names.push_back(printable(name));
        }
        if (_repeated.size() > mostNamed)
            names.emplace_back("...");
        _reading.forest.notes.push_back(_csv.file + ": of trees with the same id the first one has it, " +
                                        std::to_string(trees) + " go without: " + joined(names));
    }

    void noteUnmatched() {
        if (_unmatched.empty())
            return;
        std::size_t trees = 0;
        std::vector<std::string> names;
        for (const auto& [name, rows] : _unmatched) {
            trees += rows;
            names.push_back(printable(name) + " (" + std::to_string(rows) + ')');
        }
        _reading.forest.notes.push_back(_csv.file + ": " + std::to_string(trees) + " trees stand as " +
                                        inQuotes(_reading.forest.species[_default.value_or(0)].name) + ": " +
                                        joined(names));
    }

    TableReader& _table;
    ForestReading& _reading;
    CsvTable _csv;
    bool _complete = true;
    bool _openGrown = false;
    float _leaves = 1.0f;

    Measure _x{"x", worldCoordinates}, _y{"y", worldCoordinates}, _z{"z", worldCoordinates};
    Measure _height{"height", rangeOf("height")};
    Measure _trunkDiameter{"trunk_diameter", rangeOf("trunk_diameter")};
    Measure _crownWidth{"crown_width", rangeOf("crown_width")};
    Measure* const _measures[6] = {&_x, &_y, &_z, &_height, &_trunkDiameter, &_crownWidth};
    std::optional<std::size_t> _id, _species;
    std::string _defaultName;
    std::optional<std::size_t> _default;
    std::map<std::string, std::size_t> _unmatched; ///< Name to number of rows.
    std::map<std::string, std::size_t> _repeated;  ///< Id to number of rows that go without.
};

} // namespace

void readInventory(TableReader& table, ForestReading& reading) {
    InventoryReader(table, reading).read();
}

} // namespace osgTreeWind
