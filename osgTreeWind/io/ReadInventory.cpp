// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/InventoryColumns.h>
#include <osgTreeWind/io/InventoryPlaces.h>
#include <osgTreeWind/io/InventorySizes.h>
#include <osgTreeWind/io/SpreadOfPlaces.h>
#include <osgTreeWind/species/SizeLaws.h>

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace osgTreeWind {

namespace {

using RowCounts = std::map<std::string, std::size_t>;

/// How many ids, and names of species, a note tells before it only counts them.
constexpr std::size_t mostNamed = 10, mostSpecies = 300;

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
    for (std::size_t i = 0; i < std::min(sorted.size(), mostSpecies); ++i)
        names.push_back((sorted[i].first.empty() ? "no name" : printable(sorted[i].first)) + " (" +
                        std::to_string(sorted[i].second) + ')');
    if (sorted.size() > mostSpecies)
        names.push_back("and " + std::to_string(sorted.size() - mostSpecies) + " more names");
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
        _saysSkip = _table.read("skip", _skip);
        _table.read("missing", _sizes.missing);
        _leaves = _reading.leaves;
        _table.read("leaves", _leaves, treeRange("leaves"));
        readDefaultSpecies();
        _rows = openTreeRows(_table, _reading);
        _columns.read(_table, _rows.get());
        auto places = InventoryPlaces::find(_table, _rows.get(), _columns, _reading);
        if (!places || !_complete || !_columns.complete())
            return;
        _places = std::move(*places);
        readRows(seed);
        noteSkipped();
        noteUnmatched();
        noteRepeated();
        noteSizes();
        noteEstimated();
        noteFarAway();
    }

private:
    void readDefaultSpecies() {
        if (_table.read("default_species", _defaultName)) {
            _default = _reading.speciesOrBuiltIn(_defaultName);
            if (!_default) {
                _table.problem("default_species", "no species " + inQuotes(_defaultName));
                _complete = false;
            }
        } else if (_reading.saysSpecies && _reading.declaredSpecies == 1)
            _default = 0;
    }
    /// What stands for a tree whose name no species has.
    std::size_t defaultSpecies() {
        if (!_default)
            _default = _reading.speciesOrBuiltIn("broadleaf");
        return _default.value_or(0);
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
        Diagnostic problem{_rows->file(), isTable ? 1 : 0, 0, "",
                           std::string("an inventory without trees: no ") +
                               (isTable ? "row below the header" : "feature is chosen")};
        if (_skipped > 0) {
            problem = _firstSkipped;
            problem.message += "; no row has a place";
        }
        _reading.log.add(problem);
    }

    void readRow(Random& random) {
        ++_row;
        TreePlacement tree;
        const VectorPlace place = taken(_places.of(*_rows, _columns, _row - 1));
        tree.position = place.position;
        if (!isTree())
            return;
        tree.size.height = _sizes.of(*_rows, _columns.height);
        tree.size.trunkDiameter = _sizes.of(*_rows, _columns.trunkDiameter);
        if (tree.size.trunkDiameter == 0.0f)
            tree.size.trunkDiameter = _sizes.of(*_rows, _columns.circumference) / glm::pi<float>();
        tree.size.crownWidth = _sizes.of(*_rows, _columns.crownWidth);
        if (tree.size.crownWidth == 0.0f && place.width)
            tree.size.crownWidth = _sizes.ofOutline(*_rows, _columns.crownWidth, *place.width);
        tree.species = rowSpecies();
        tree.openGrown = _openGrown;
        tree.leaves = _leaves;
        tree.heading = random.uniform() * glm::two_pi<float>();
        tree.seed = static_cast<std::uint32_t>(random.next());
        const std::string said = _columns.id ? _rows->text(*_columns.id) : std::string();
        estimate(tree, said.empty() ? std::to_string(_row) : said);
        if (_standsFor)
            ++_unmatched[*_standsFor];
        tree.name = nameOf(said);
        _spread.add(glm::dvec2(tree.position), [&] { return rowText(); });
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

    std::size_t rowSpecies() {
        _standsFor.reset();
        if (_columns.species.empty()) {
            if (_defaultName.empty() && !_default)
                _isSpeciesSaid = false;
            return defaultSpecies();
        }
        std::string name;
        for (const std::size_t column : _columns.species) {
            const std::string said = _rows->text(column);
            if (const auto index = known(said))
                return *index;
            name = name.empty() ? said : name;
        }
        if (const auto index = kinOf(name)) {
            ++_kin[name + " as " + _reading.forest.species[*index].name];
            return *index;
        }
        _standsFor = name;
        return defaultSpecies();
    }

    /// ForestReading::speciesOrBuiltIn(), which is asked once for each name.
    std::optional<std::size_t> known(const std::string& name) {
        const auto [entry, isNew] = _known.emplace(name, std::nullopt);
        if (isNew)
            entry->second = _reading.speciesOrBuiltIn(name);
        return entry->second;
    }
    /// What a name that is not known is called after, likewise.
    std::optional<std::size_t> kinOf(const std::string& name) {
        const auto [entry, isNew] = _kinOf.emplace(name, std::nullopt);
        if (isNew)
            entry->second = _reading.takeBuiltIn(_reading.builtIn().findKin(name));
        return entry->second;
    }

    void estimate(TreePlacement& tree, const std::string& id) {
        const SizeEstimate estimate =
            estimateSize(tree.size, _reading.forest.species[tree.species], tree.openGrown, id);
        tree.size = estimate.size;
        tree.estimated = estimate.estimated;
        _heights += tree.estimated.height;
        _diameters += tree.estimated.trunkDiameter;
        _crowns += tree.estimated.crownWidth;
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
        if (!_saysSkip && _skipped < _row && 2 * _skipped > _row) {
            Diagnostic problem = _firstSkipped;
            problem.message += "; so it is with " + std::to_string(_skipped) + " of " + std::to_string(_row) +
                               " rows: inventory.skip = true leaves them out";
            _reading.log.add(problem);
        } else if (_skipped > 0 && _skipped < _row)
            _reading.forest.notes.push_back(
                _rows->file() + ": " + std::to_string(_skipped) + " of " + std::to_string(_row) +
                " rows have no place and are left out, the first: " + _firstSkipped.text());
    }

    void noteSizes() {
        for (const Diagnostic& problem : _sizes.problems())
            _reading.log.add(problem);
        for (const std::string& note : _sizes.notes())
            _reading.forest.notes.push_back(_rows->file() + ": " + note);
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
        if (!_kin.empty())
            _reading.forest.notes.push_back(
                _rows->file() + ": " + std::to_string(sumOf(_kin)) +
                " trees, whose names no species has, stand as what they are called after: " +
                mostFrequent(_kin));
        const std::string name = _default ? inQuotes(_reading.forest.species[*_default].name) : std::string();
        if (!_isSpeciesSaid)
            _reading.forest.notes.push_back(_rows->file() + ": all trees stand as " + name +
                                            ": neither a column of species nor default_species is named");
        else if (!_unmatched.empty())
            _reading.forest.notes.push_back(_rows->file() + ": " + std::to_string(sumOf(_unmatched)) +
                                            " trees, whose names no species has, stand as " + name + ": " +
                                            mostFrequent(_unmatched));
    }

    /// "line 17", or "feature 3".
    std::string rowText() const {
        const Diagnostic row = _rows->problem("", "");
        return row.line > 0 ? "line " + std::to_string(row.line)
                            : row.message.substr(0, row.message.find(": "));
    }

    /// Names the tree that stands by far the farthest from the others, as one whose place is wrong does: a
    /// problem where it is too far for any forest.
    void noteFarAway() {
        const std::optional<OutlyingPlace> far = _spread.outlier();
        if (!far)
            return;
        const auto kilometres = [](double metres) { return numberText(std::ceil(metres / 1000.0)) + " km"; };
        const std::string message =
            far->row + ": this tree stands " + kilometres(far->distance) +
            " from the middle of the others, which are within " + kilometres(far->others) +
            (far->count > 1 ? "; so far are " + std::to_string(far->count) : std::string());
        if (far->distance > farthestTree)
            _reading.log.add(fileProblem(
                _rows->file(), message + "; expected trees within 100 km: a filter leaves such rows out"));
        else
            _reading.forest.notes.push_back(_rows->file() + ": " + message);
    }

    TableReader& _table;
    ForestReading& _reading;
    std::unique_ptr<TreeRows> _rows;
    InventoryColumns _columns;
    InventoryPlaces _places;
    bool _complete = true;
    bool _openGrown = false, _saysCompany = false, _skip = true, _saysSkip = false, _isSpeciesSaid = true;
    float _leaves = 1.0f;
    std::string _defaultName;
    std::optional<std::size_t> _default;
    InventorySizes _sizes;
    SpreadOfPlaces _spread;
    Diagnostics _problems; ///< With the row.
    Diagnostic _firstSkipped;
    std::size_t _row = 0, _skipped = 0;
    std::size_t _heights = 0, _diameters = 0, _crowns = 0; ///< That were estimated.
    std::optional<std::string> _standsFor; ///< The name of an unknown species that the row has.
    std::unordered_map<std::string, std::optional<std::size_t>> _known, _kinOf; ///< Names to species.
    RowCounts _kin;       ///< "river birch as silver birch" to numbers of rows.
    RowCounts _unmatched; ///< Names of species to numbers of rows.
    RowCounts _repeated;  ///< Ids to numbers of rows that go without.
};

} // namespace

void readInventory(TableReader& table, ForestReading& reading) {
    InventoryReader(table, reading).read();
}

} // namespace osgTreeWind
