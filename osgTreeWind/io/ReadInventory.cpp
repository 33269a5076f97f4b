// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/InventoryColumns.h>
#include <osgTreeWind/io/InventoryPlaces.h>
#include <osgTreeWind/io/InventorySizes.h>
#include <osgTreeWind/io/PlaceSpread.h>
#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/species/SizeLaws.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <unordered_map>

namespace osgTreeWind {

namespace {

using RowCounts = std::map<std::string, std::size_t>;

/// Number of ids and of species names that a note lists.
constexpr std::size_t maxListedIds = 10, maxListedNames = 300;

std::size_t sumOf(const RowCounts& rows) {
    std::size_t sum = 0;
    for (const auto& [name, count] : rows)
        sum += count;
    return sum;
}

/// "a (7), b (2)", the most frequent names first.
std::string countsText(const RowCounts& rows) {
    std::vector<std::pair<std::string, std::size_t>> sorted(rows.begin(), rows.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    std::vector<std::string> names;
    for (std::size_t i = 0; i < std::min(sorted.size(), maxListedNames); ++i)
        names.push_back((sorted[i].first.empty() ? "no name" : printable(sorted[i].first)) + " (" +
                        std::to_string(sorted[i].second) + ')');
    if (sorted.size() > maxListedNames)
        names.push_back("and " + std::to_string(sorted.size() - maxListedNames) + " more names");
    return joined(names);
}

/// Converts the rows of one inventory to trees. Problems with a row give the file and the line or feature.
class InventoryReader {
public:
    InventoryReader(TableReader& table, DocumentSpecies& species, DocumentTrees& trees,
                    const std::function<GroundPtr()>& findGround)
        : _table(table), _species(species), _trees(trees), _findGround(findGround) {}

    void read(const InputFolders& folders, const TreeDefaults& defaults, SceneMap& map) {
        std::uint32_t seed = defaults.seed;
        _table.read("seed", seed);
        _isOpenGrownGiven = _table.read("open_grown", _openGrown);
        _isSkipGiven = _table.read("skip", _skip);
        _table.read("missing", _sizes.missing);
        for (const char* const mark : {".", ","})
            if (_table.hasText("decimal", mark))
                _sizes.decimalComma = *mark == ',';
        _leaves = defaults.leaves;
        _table.read("leaves", _leaves, treeRange("leaves"));
        _table.readChoice<Z>(
            "z", _z, {{"foot", Z::Foot}, {"ignore", Z::Ignore}, {"height", Z::Height}, {"top", Z::Top}});
        readDefaultSpecies();
        _rows = openTreeRows(_table, folders);
        _columns.read(_table, _rows.get());
        auto places = InventoryPlaces::find(_table, _rows.get(), _columns, map);
        if (!places || !_complete || !_columns.isComplete())
            return;
        _places = std::move(*places);
        if (_places.exchanged())
            _trees.exchangedPlaces.push_back(*_places.exchanged());
        if (_z == Z::Top)
            _ground = _findGround();
        if (_z == Z::Top && !_ground && !_columns.height.column)
            return _table.problem("z", "\"top\" needs a ground or columns.height");
        const std::size_t begin = _trees.size();
        readRows(seed);
        checkPlaces(map.crs());
        if (_hasFeet)
            _trees.inventoryHeights.push_back(
                {_rows->file(), begin, _trees.size(), !_columns.z.column && !_table.has("z")});
        for (const std::string& warning : _rows->warnings())
            addNote(warning);
        reportSkippedRows();
        reportUnknownSpecies();
        reportDuplicateIds();
        reportSizes();
        reportEstimatedSizes();
        reportOutlier();
    }

private:
    /// What the z of a place is.
    enum class Z { Foot, Ignore, Height, Top };
    /// A name that no species has.
    struct UnknownName {
        std::optional<std::size_t> related; ///< Species that it is read as.
        std::size_t rows = 0;
    };

    void readDefaultSpecies() {
        if (_table.read("default_species", _defaultName)) {
            _default = _species.findOrAdd(_defaultName);
            if (!_default) {
                _table.problem("default_species", "no species " + inQuotes(_defaultName));
                _complete = false;
            }
        } else if (_species.isSingle()) {
            _default = 0;
            _isDefaultOnlySpecies = true;
        }
    }
    /// The species for trees of unknown species.
    std::size_t defaultSpecies() {
        if (!_default)
            _default = _species.findOrAdd("broadleaf");
        return _default.value_or(0);
    }

    void readRows(std::uint32_t seed) {
        Random random(seed);
        _places.rewind(*_rows, _columns);
        Result<bool> found = _rows->next();
        for (; found && found.value(); found = _rows->next()) {
            if (!_trees.canAdd(1, _table, "file"))
                return;
            readRow(random);
        }
        if (!found)
            _table.report(found.problems().front());
        else if (_row == _skipped)
            reportEmpty();
    }

    void reportEmpty() {
        const bool isTable = _rows->format() == "CSV";
        Diagnostic problem{_rows->file(), isTable ? 1 : 0, 0, "",
                           std::string("the inventory has no trees: no ") +
                               (isTable ? "row below the header" : "feature is selected")};
        if (_skipped > 0) {
            problem = _firstSkipped;
            problem.message += "; no row has a place";
        }
        _table.report(problem);
    }

    void readRow(Random& random) {
        ++_row;
        TreePlacement tree;
        const VectorPlace place = valueOf(_places.placeOf(*_rows, _columns, _row - 1));
        if (!isRowValid())
            return;
        tree.position = {glm::dvec2(place.position),
                         _z == Z::Foot && place.hasHeight ? place.position.z : 0.0};
        _unknownHeights += std::isnan(place.position.z);
        tree.species = rowSpecies();
        const Species& species = _species.all()[tree.species];
        const InventorySize height = _sizes.read(*_rows, _columns.height, species.height.largest);
        InventorySize diameter = _sizes.read(*_rows, _columns.trunkDiameter);
        if (diameter.metres == 0.0f) {
            diameter = _sizes.read(*_rows, _columns.circumference);
            diameter.metres /= glm::pi<float>();
        }
        const InventorySize crown = _sizes.read(*_rows, _columns.crownWidth, species.crown.largest);
        tree.size.height =
            height.metres == 0.0f && place.hasHeight ? heightByZ(place.position, species) : height.metres;
        tree.size.trunkDiameter = diameter.metres;
        tree.size.crownWidth = crown.metres;
        if (tree.size.crownWidth == 0.0f && place.width)
            tree.size.crownWidth =
                _sizes.readGeometry(*_rows, _columns.crownWidth, "the outline of a crown with a width",
                                    *place.width, species.crown.largest);
        tree.openGrown = _openGrown;
        tree.leaves = _leaves;
        tree.heading = random.uniform() * glm::two_pi<float>();
        tree.seed = static_cast<std::uint32_t>(random.next());
        const std::string id = _columns.id ? _rows->text(*_columns.id) : std::string();
        estimate(tree, id.empty() ? std::to_string(_row) : id);
        tree.estimated.height |= height.isEstimate;
        tree.estimated.trunkDiameter |= diameter.isEstimate;
        tree.estimated.crownWidth |= crown.isEstimate;
        const bool isBelowTop = _z == Z::Top && place.hasHeight && !_ground;
        if (isBelowTop)
            tree.position.z = place.position.z - static_cast<double>(tree.size.height);
        const bool hasFoot = isBelowTop || (_z == Z::Foot && place.hasHeight);
        _hasFeet |= hasFoot;
        tree.name = uniqueName(id);
        _spread.add(glm::dvec2(tree.position), [&] { return rowText(); });
        _trees.add(tree, !hasFoot, {!_isOpenGrownGiven});
    }

    /// Reports places that their CRS cannot have, such as eastings with the number of a zone before them, and
    /// notes a map without a CRS.
    void checkPlaces(const std::optional<Crs>& crs) {
        constexpr double minMap = 1e5, minDoubt = 1e7; // metres
        const glm::dvec2 place(_trees.bounds().low);
        const double largest = glm::max(std::abs(place.x), std::abs(place.y));
        if (_trees.size() == 0 || !(largest > minMap) || (crs && largest <= minDoubt))
            return;
        if (!crs)
            return addNote("no crs is known, and places are taken as metres; inventory.crs sets a system");
        const auto degrees = longitudeLatitudeOf(place, *crs);
        const auto back = CrsTransform::between(Crs::wgs84(), *crs);
        glm::dvec2 found = degrees.value_or(glm::dvec2(0.0));
        if (!degrees || !back || !back.value().apply(found) || !(glm::distance(found, place) < 1.0))
            _table.problem("crs", "the place " + numberText(std::round(place.x)) + ", " +
                                      numberText(std::round(place.y)) + " is not in " + crs->name());
    }

    /// The height of a tree that its z gives; 0 if it gives none.
    float heightByZ(const glm::dvec3& place, const Species& species) {
        if (_z == Z::Height && place.z != 0.0)
            return _sizes.readGeometry(*_rows, _columns.height, "a z", place.z, species.height.largest);
        const auto ground = _z == Z::Top && _ground ? heightOf(*_ground, glm::dvec2(place)) : std::nullopt;
        return ground ? _sizes.readGeometry(*_rows, _columns.height, "a z above the ground",
                                            place.z - *ground, species.height.largest)
                      : 0.0f;
    }

    template <typename T>
    T valueOf(const Result<T>& result) {
        _problems.insert(_problems.end(), result.problems().begin(), result.problems().end());
        return result ? result.value() : T();
    }

    /// Whether the row has no problems. Otherwise reports them or counts the row as skipped.
    bool isRowValid() {
        if (_problems.empty())
            return true;
        if (_skip && _skipped++ == 0)
            _firstSkipped = _problems.front();
        for (const Diagnostic& problem : _problems)
            if (!_skip)
                _table.report(problem);
        _problems.clear();
        return false;
    }

    std::size_t rowSpecies() {
        if (_columns.species.empty()) {
            if (_defaultName.empty() && !_default)
                _isSpeciesGiven = false;
            return defaultSpecies();
        }
        std::string name;
        for (const std::size_t column : _columns.species) {
            const std::string cell = _rows->text(column);
            if (const auto index = findInCell(cell))
                return *index;
            name = name.empty() ? cell : name;
        }
        const std::string leafType = _columns.leafType ? _rows->text(*_columns.leafType) : std::string();
        const auto [entry, isNew] = _unknownNames.try_emplace({name, leafType});
        UnknownName& unknown = entry->second;
        if (isNew) {
            unknown.related = _species.addBuiltIn(_species.builtIn().findRelated(name));
            if (!unknown.related && !_isDefaultOnlySpecies)
                unknown.related = findByLeafType(leafType);
        }
        ++unknown.rows;
        return unknown.related ? *unknown.related : defaultSpecies();
    }

    /// The species of a cell, or the first that is known of several: "Quercus robur;Fagus sylvatica".
    std::optional<std::size_t> findInCell(const std::string& cell) {
        if (cell.find(';') == std::string::npos)
            return findSpecies(cell);
        std::istringstream names(cell);
        for (std::string name; std::getline(names, name, ';');)
            if (const auto index = findSpecies(std::string(trimmed(name)))) {
                ++_severalSpecies;
                return index;
            }
        return std::nullopt;
    }

    /// The generic species of OpenStreetMap's leaf types.
    std::optional<std::size_t> findByLeafType(const std::string& leafType) {
        return leafType == "needleleaved"  ? _species.findOrAdd("conifer")
               : leafType == "broadleaved" ? _species.findOrAdd("broadleaf")
                                           : std::nullopt;
    }

    /// Caches DocumentSpecies::findOrAdd().
    std::optional<std::size_t> findSpecies(const std::string& name) {
        const auto [entry, isNew] = _speciesCache.try_emplace(name);
        if (isNew)
            entry->second = _species.findOrAdd(name);
        return entry->second;
    }

    void estimate(TreePlacement& tree, const std::string& id) {
        const SizeEstimate estimate =
            estimateSize(tree.size, _species.all()[tree.species], tree.openGrown, id);
        tree.size = estimate.size;
        tree.estimated = estimate.estimated;
        _heights += tree.estimated.height;
        _diameters += tree.estimated.trunkDiameter;
        _crowns += tree.estimated.crownWidth;
        _diameterVariance += estimate.diameterSpread * estimate.diameterSpread;
    }

    /// Empty if another tree has the name.
    std::string uniqueName(const std::string& name) {
        if (name.empty() || _trees.reserveName(name))
            return name;
        ++_duplicateIds[name];
        return {};
    }

    void reportDuplicateIds() {
        if (_duplicateIds.empty())
            return;
        std::vector<std::string> names;
        for (const auto& [name, rows] : _duplicateIds)
            if (names.size() < maxListedIds)
                names.push_back(printable(name));
        if (_duplicateIds.size() > maxListedIds)
            names.emplace_back("...");
        addNote(std::to_string(sumOf(_duplicateIds)) +
                " trees have no id, because another tree has it: " + joined(names));
    }

    void reportSkippedRows() {
        if (!_isSkipGiven && _skipped < _row && 2 * _skipped > _row) {
            Diagnostic problem = _firstSkipped;
            problem.message += "; the same applies to " + std::to_string(_skipped) + " of " +
                               std::to_string(_row) + " rows: to leave them out, set inventory.skip = true";
            _table.report(problem);
        } else if (_skipped > 0 && _skipped < _row)
            addNote(std::to_string(_skipped) + " of " + std::to_string(_row) +
                    " rows have no place and are left out, the first: " + _firstSkipped.text());
    }

    void reportSizes() {
        if (_unknownHeights > 0)
            addNote("a z of -9999 or similar does not count: " + std::to_string(_unknownHeights) + " trees");
        for (const Diagnostic& problem : _sizes.problems())
            _table.report(problem);
        for (const std::string& note : _sizes.notes())
            addNote(note);
    }

    void reportEstimatedSizes() {
        std::vector<std::string> counts;
        for (const auto& [size, trees] :
             {std::pair("height", _heights), {"trunk diameter", _diameters}, {"crown width", _crowns}})
            if (trees > 0)
                counts.push_back(std::string(size) + " of " + std::to_string(trees));
        if (!counts.empty())
            addNote("estimated by the laws of the species: " + joined(counts) + " trees");
        if (_diameters > 0)
            addNote(
                "two of three estimated trunk diameters are right within a factor of " +
                numberText(std::round(100.0 * math::exp(std::sqrt(_diameterVariance / _diameters))) / 100.0));
    }

    void reportUnknownSpecies() {
        RowCounts related, unknown; // by "river birch as silver birch", and by name
        for (const auto& [names, found] : _unknownNames)
            if (found.related)
                related[(names.first.empty() ? "no name" : names.first) + " as " +
                        _species.all()[*found.related].name] += found.rows;
            else
                unknown[names.first] += found.rows;
        if (_severalSpecies > 0)
            addNote("of several species in a cell, the first that is known counts: " +
                    std::to_string(_severalSpecies) + " trees");
        if (!related.empty())
            addNote(std::to_string(sumOf(related)) +
                    " trees of unknown species are read as related species: " + countsText(related));
        const std::string name = _default ? inQuotes(_species.all()[*_default].name) : std::string();
        if (!_isSpeciesGiven)
            addNote("all trees are read as " + name +
                    ", because there is no column of species and no default_species");
        else if (!unknown.empty())
            addNote(std::to_string(sumOf(unknown)) + " trees of unknown species are read as " + name + ": " +
                    countsText(unknown));
    }

    void addNote(const std::string& note) { _table.note(_rows->file() + ": " + note); }

    /// "line 17", or "feature 3".
    std::string rowText() const {
        const Diagnostic row = _rows->problem("", "");
        return row.line > 0 ? "line " + std::to_string(row.line)
                            : row.message.substr(0, row.message.find(": "));
    }

    /// Reports a tree much farther away than the others: a note, or a problem if it is over 100 km.
    void reportOutlier() {
        const std::optional<OutlyingPlace> outlier = _spread.outlier();
        if (!outlier)
            return;
        const auto kilometres = [](double metres) { return numberText(std::ceil(metres / 1000.0)) + " km"; };
        const std::string message =
            outlier->row + ": this tree stands " + kilometres(outlier->distance) +
            " from the middle of the others, which are within " + kilometres(outlier->others) +
            (outlier->count > 1 ? "; " + std::to_string(outlier->count) + " trees are that far"
                                : std::string());
        if (outlier->distance > maxTreeDistance)
            _table.report(fileProblem(
                _rows->file(),
                message + "; expected trees within 100 km: leave such rows out with inventory.filter"));
        else
            addNote(message);
    }

    TableReader& _table;
    DocumentSpecies& _species;
    DocumentTrees& _trees;
    const std::function<GroundPtr()>& _findGround;
    GroundPtr _ground; ///< If tops are given.
    std::unique_ptr<TreeRows> _rows;
    InventoryColumns _columns;
    InventoryPlaces _places;
    bool _complete = true;
    bool _openGrown = false, _isOpenGrownGiven = false, _skip = true, _isSkipGiven = false;
    bool _isSpeciesGiven = true, _isDefaultOnlySpecies = false, _hasFeet = false;
    Z _z = Z::Foot;
    float _leaves = 1.0f;
    std::string _defaultName;
    std::optional<std::size_t> _default;
    InventorySizes _sizes;
    PlaceSpread _spread;
    Diagnostics _problems; ///< Problems of the current row.
    Diagnostic _firstSkipped;
    std::size_t _row = 0, _skipped = 0, _unknownHeights = 0;
    std::size_t _heights = 0, _diameters = 0, _crowns = 0; ///< Numbers of estimated sizes.
    double _diameterVariance = 0.0; ///< Sum over estimated diameters, of their logarithms.
    std::unordered_map<std::string, std::optional<std::size_t>> _speciesCache;
    std::map<std::pair<std::string, std::string>, UnknownName> _unknownNames; ///< By name and leaf type.
    std::size_t _severalSpecies = 0;                                          ///< Rows with several.
    RowCounts _duplicateIds;                                                  ///< Rows by id.
};

} // namespace

void readInventory(TableReader& table, const InputFolders& folders, const TreeDefaults& defaults,
                   SceneMap& map, DocumentSpecies& species, DocumentTrees& trees,
                   const std::function<GroundPtr()>& findGround) {
    InventoryReader(table, species, trees, findGround).read(folders, defaults, map);
}

} // namespace osgTreeWind
