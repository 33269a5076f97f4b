// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/InventoryColumns.h>
#include <osgTreeWind/io/InventoryPlaces.h>
#include <osgTreeWind/species/SizeLaws.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

namespace {

using RowCounts = std::map<std::string, std::size_t>;

/// How many names a note tells before it only counts them.
constexpr std::size_t mostNamed = 10;

/// Metres; the highest that was ever measured has 116.
constexpr float tallestTree = 120.0f;

std::string rounded(float metres) {
    return numberText(std::round(100.0 * static_cast<double>(metres)) / 100.0);
}

std::size_t sumOf(const RowCounts& rows) {
    std::size_t sum = 0;
    for (const auto& [name, count] : rows)
        sum += count;
    return sum;
}

/// "a (7), b (2)", those with most rows first.
std::string mostFrequent(const RowCounts& rows) {
    std::vector<std::pair<std::string, std::size_t>> sorted(rows.begin(), rows.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(sorted.size(), mostNamed); ++i)
        names.push_back((sorted[i].first.empty() ? "no name" : printable(sorted[i].first)) + " (" +
                        std::to_string(sorted[i].second) + ')');
    if (sorted.size() > mostNamed)
        names.push_back("and " + std::to_string(sorted.size() - mostNamed) + " more names");
    return joined(names);
}

/// Turns the rows of one inventory into trees. Problems with a row name the file and its line or feature.
class InventoryReader {
public:
    InventoryReader(TableReader& table, ForestReading& reading) : _table(table), _reading(reading) {}

    void read() {
        std::uint32_t seed = _reading.seed;
        _table.read("seed", seed);
        _saysCompany = _table.read("open_grown", _openGrown);
        _table.read("skip", _skip);
        _leaves = _reading.leaves;
        _table.read("leaves", _leaves, treeRange("leaves"));
        readDefaultSpecies();
        _rows = openTreeRows(_table, _reading);
        _columns.read(_table, _rows.get());
        if (_columns.species.empty() && !_default && _defaultName.empty() && _rows) {
            _table.problem("columns", "expected a species column, or default_species beside columns");
            _complete = false;
        }
        auto places = InventoryPlaces::find(_table, _rows.get(), _columns, _reading);
        if (!places || !_complete || !_columns.complete())
            return;
        _places = std::move(*places);
        readRows(seed);
        noteSkipped();
        noteUnmatched();
        noteRepeated();
        noteEstimated();
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

    void readRows(std::uint32_t seed) {
        Random random(seed);
        _places.rewind(*_rows, _columns);
        Result<bool> found = _rows->next();
        for (; found && found.value(); found = _rows->next()) {
            if (!_reading.roomFor(1, _table, "file"))
                return;
            readRow(random);
        }
        if (!found)
            _reading.log.add(found.problems().front());
        else if (_row == _skipped)
            noteNone();
    }

    void noteNone() {
        const bool isTable = _rows->format() == "CSV";
        _reading.log.add({_rows->file(), isTable ? 1 : 0, 0, "",
                          std::string("an inventory without trees: no ") +
                              (_skipped > 0 ? "row is one; the first: " + _firstSkipped.text()
                               : isTable    ? "row below the header"
                                            : "feature is chosen")});
    }

    void readRow(Random& random) {
        ++_row;
        TreePlacement tree;
        const VectorPlace place = taken(_places.of(*_rows, _columns, _row - 1));
        tree.position = place.position;
        tree.size.height = size(_columns.height);
        tree.size.trunkDiameter = size(_columns.trunkDiameter);
        if (tree.size.trunkDiameter == 0.0f)
            tree.size.trunkDiameter = size(_columns.circumference) / glm::pi<float>();
        tree.size.crownWidth = size(_columns.crownWidth);
        if (tree.size.crownWidth == 0.0f && place.width)
            tree.size.crownWidth = outlineWidth(*place.width);
        if (!isTree())
            return;
        tree.species = rowSpecies();
        tree.openGrown = _openGrown;
        tree.leaves = _leaves;
        tree.heading = random.uniform() * glm::two_pi<float>();
        tree.seed = static_cast<std::uint32_t>(random.next());
        const std::string said = _columns.id ? _rows->text(*_columns.id) : std::string();
        if (!estimate(tree, said.empty() ? std::to_string(_row) : said))
            return;
        if (_standsFor)
            ++_unmatched[*_standsFor];
        tree.name = nameOf(said);
        _reading.addTree(tree, !place.hasHeight, {!_saysCompany});
    }

    template <typename T>
    T taken(const Result<T>& result) {
        _problems.insert(_problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : T();
    }

    /// Settles what is wrong with a row: false where it is none of a tree, as the log or a note says.
    bool isTree() {
        if (_problems.empty())
            return true;
        if (_skip && _skipped++ == 0)
            _firstSkipped = _problems.front();
        for (const Diagnostic& problem : _problems)
            if (!_skip)
                _reading.log.add(problem);
        _problems.clear();
        return false;
    }

    /// Metres; 0 when the row does not say.
    float size(const Measure& measure) {
        if (!measure.column || !_rows->has(*measure.column))
            return 0.0f;
        return static_cast<float>(taken(metresOfRow(*_rows, measure)));
    }

    float outlineWidth(double width) {
        if (!_columns.crownWidth.range.contains(width))
            _problems.push_back(_rows->problem("", "expected the outline of a crown, " +
                                                       _columns.crownWidth.range.text() +
                                                       " metres wide, found " + numberText(width)));
        return static_cast<float>(width);
    }

    std::size_t rowSpecies() {
        _standsFor.reset();
        if (_columns.species.empty())
            return *_default;
        std::string name;
        for (const std::size_t column : _columns.species) {
            const std::string said = _rows->text(column);
            if (const auto index = _reading.speciesOrBuiltIn(said))
                return *index;
            name = name.empty() ? said : name;
        }
        if (_default)
            _standsFor = name;
        else if (_unmatched[name]++ == 0)
            _reading.log.add(_rows->problem(_rows->columns()[_columns.species.front()],
                                            "no species " + inQuotes(name) + ", and no default_species"));
        return _default.value_or(0);
    }

    /// False where what is given is no size of a tree.
    bool estimate(TreePlacement& tree, const std::string& id) {
        if (tree.species >= _reading.forest.species.size())
            return true;
        const SizeEstimate estimate =
            estimateSize(tree.size, _reading.forest.species[tree.species], tree.openGrown, id);
        if (estimate.estimated.height && estimate.size.height > tallestTree)
            _problems.push_back(_rows->problem(
                "", "a trunk of " + rounded(tree.size.trunkDiameter) + " m is that of no " +
                        _reading.forest.species[tree.species].name + ": such a tree would be " +
                        rounded(estimate.size.height) + " m high"));
        if (!isTree())
            return false;
        tree.size = estimate.size;
        tree.estimated = estimate.estimated;
        _heights += tree.estimated.height;
        _diameters += tree.estimated.trunkDiameter;
        _crowns += tree.estimated.crownWidth;
        return true;
    }

    /// Empty where it has none of its own.
    std::string nameOf(const std::string& name) {
        if (name.empty() || _reading.treeNames.insert(name).second)
            return name;
        ++_repeated[name];
        return {};
    }

    void noteRepeated() {
        if (_repeated.empty())
            return;
        std::vector<std::string> names;
        for (const auto& [name, rows] : _repeated)
            if (names.size() < mostNamed)
                names.push_back(printable(name));
        if (_repeated.size() > mostNamed)
            names.emplace_back("...");
        _reading.forest.notes.push_back(_rows->file() + ": of trees with the same id the first one has it, " +
                                        std::to_string(sumOf(_repeated)) + " go without: " + joined(names));
    }

    void noteSkipped() {
        if (_skipped > 0 && _skipped < _row)
            _reading.forest.notes.push_back(
                _rows->file() + ": " + std::to_string(_skipped) + " of " + std::to_string(_row) +
                " rows are no trees and left out, the first: " + _firstSkipped.text());
    }

    void noteEstimated() {
        std::vector<std::string> counts;
        for (const auto& [size, trees] :
             {std::pair("height", _heights), {"trunk diameter", _diameters}, {"crown width", _crowns}})
            if (trees > 0)
                counts.push_back(std::string(size) + " of " + std::to_string(trees));
        if (!counts.empty())
            _reading.forest.notes.push_back(
                _rows->file() + ": not given, by the laws of the species: " + joined(counts) + " trees");
    }

    void noteUnmatched() {
        if (_default && !_unmatched.empty())
            _reading.forest.notes.push_back(
                _rows->file() + ": " + std::to_string(sumOf(_unmatched)) + " trees stand as " +
                inQuotes(_reading.forest.species[*_default].name) + ": " + mostFrequent(_unmatched));
    }

    TableReader& _table;
    ForestReading& _reading;
    std::unique_ptr<TreeRows> _rows;
    InventoryColumns _columns;
    InventoryPlaces _places;
    bool _complete = true;
    bool _openGrown = false, _saysCompany = false, _skip = false;
    float _leaves = 1.0f;
    std::string _defaultName;
    std::optional<std::size_t> _default;
    Diagnostics _problems; ///< With the row.
    Diagnostic _firstSkipped;
    std::size_t _row = 0, _skipped = 0;
    std::size_t _heights = 0, _diameters = 0, _crowns = 0; ///< That were estimated.
    std::optional<std::string> _standsFor; ///< The name of an unknown species that the row has.
    RowCounts _unmatched;                  ///< Names of species to numbers of rows.
    RowCounts _repeated;                   ///< Ids to numbers of rows that go without.
};

} // namespace

void readInventory(TableReader& table, ForestReading& reading) {
    InventoryReader(table, reading).read();
}

} // namespace osgTreeWind
