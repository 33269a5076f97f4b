// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/output/NetCdfFile.h>
#include <examples/osgtreewind/simulate/MotionFile.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/WindFiles.h>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace osgTreeWind;

namespace {

class MotionNetCdf final : public MotionFile {
public:
    MotionNetCdf(const std::string& path, const MotionTable& table, const ForestSimulation& simulation,
                 std::size_t steps)
        : _table(table), _simulation(simulation), _whole(path), _file(_whole.writePath(), NC_NETCDF4) {
        defineTime(simulation.wind());
        const int trees = _file.defineDimension("tree", table.trees.size());
        const int rows = table.isOfUnits ? _file.defineDimension("unit", table.rowCount()) : trees;
        Writes writes = defineTrees(simulation, trees);
        if (table.isOfUnits)
            defineUnits(rows, writes);
        defineColumns(rows, steps);
        _file.describeFile(table.title);
        const glm::dvec3& origin = simulation.description().origin;
        _file.setAttribute(NetCdfFile::global, "scene_origin", std::vector{origin.x, origin.y, origin.z});
        _file.setAttribute(NetCdfFile::global, "comment",
                           "Scene: x east, y north, z up, metres from scene_origin. x, y and z of trees are "
                           "coordinates of the map.");
        _file.endDefinitions();
        for (const auto& write : writes)
            write();
        checkFile();
    }

    void write(double time) override {
        _table.values(_simulation, 0, _table.trees.size(), _values);
        const std::size_t rows = _table.rowCount(), columns = _table.columns.size();
        _times.push_back(_start + time);
        for (std::size_t c = 0; c < columns; ++c)
            for (std::size_t row = 0; row < rows; ++row)
                _steps[c].push_back(_values[row * columns + c]);
        if (_times.size() == _stepsPerChunk)
            flush();
    }

    void finish() override {
        flush();
        if (!_file.close() || !_whole.commit())
            throwWriteError(_whole, _file.problem());
    }

private:
    void checkFile() {
        if (!_file.problem().empty())
            throwWriteError(_whole, _file.problem());
    }

    void defineTime(const Wind& wind) {
        _timeDimension = _file.defineDimension("time", NC_UNLIMITED);
        _time = _file.defineVariable("time", NC_DOUBLE, {_timeDimension});
        const std::optional<double> date = startDateOf(wind);
        _file.describe(_time, "time", date ? "seconds since " + cfTime(std::floor(*date)) : "s");
        _file.setAttribute(_time, "axis", "T");
        if (!date)
            return;
        _start = *date - std::floor(*date); // the units have whole seconds
        _file.setAttribute(_time, "standard_name", "time");
        _file.setAttribute(_time, "calendar", "standard");
    }

    /// "2017-06-03 18:00:00", which more readers know than isoTimeText().
    static std::string cfTime(double date) {
        std::string text = isoTimeText(date);
        text[text.find('T')] = ' ';
        text.pop_back();
        return text;
    }

    using Writes = std::vector<std::function<void()>>; ///< To be called after the definitions.

    /// Defines a variable that does not change with time.
    template <typename T>
    int defineFixed(const char* name, int type, int dimension, const char* words, std::vector<T> values,
                    Writes& writes) {
        const int variable = _file.defineVariable(name, type, {dimension});
        _file.setAttribute(variable, "long_name", words);
        writes.push_back([=, given = std::move(values)] { _file.write(variable, given); });
        return variable;
    }

    /// @return what writes the variables of trees.
    Writes defineTrees(const ForestSimulation& simulation, int trees) {
        Writes writes;
        const Result<Crs> map = Crs::parseMap(simulation.description().crs);
        _isOnMap = !simulation.description().crs.empty() && map;
        if (_isOnMap) {
            const int crs = _file.defineMap(map.value());
            writes.push_back([=] { _file.write(crs, std::vector{0.0}); });
        }
        std::vector<int> slots;
        std::vector<std::string> ids, species;
        std::vector<double> places[3];
        for (const TreeId tree : _table.trees) {
            const TreePlacement placement = *simulation.placementOf(tree);
            slots.push_back(static_cast<int>(slotOfTree(tree)));
            ids.push_back(placement.name);
            species.push_back(simulation.description().species[placement.species].name);
            for (int axis = 0; axis < 3; ++axis)
                places[axis].push_back(placement.position[axis]);
        }
        const auto define = [&](const char* name, int type, const char* words, auto values) {
            return defineFixed(name, type, trees, words, std::move(values), writes);
        };
        define("tree", NC_INT, "number of the tree, from 0", std::move(slots));
        const int id = define("id", NC_STRING, "id of the tree in the inventory", std::move(ids));
        _file.setAttribute(id, "cf_role", "timeseries_id");
        define("species", NC_STRING, "species", std::move(species));
        const char *names[] = {"x", "y", "z"},
                   *words[] = {"foot of the tree, towards east", "foot of the tree, towards north",
                               "foot of the tree, upward"};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const int place = define(names[axis], NC_DOUBLE, words[axis], std::move(places[axis]));
            _file.setAttribute(place, "units", "m");
            if (axis < 2 && _isOnMap)
                _file.setAttribute(place, "standard_name",
                                   "projection_" + std::string(names[axis]) + "_coordinate");
            if (axis == 2)
                _file.setAttribute(place, "positive", "up");
        }
        return writes;
    }

    void defineUnits(int units, Writes& writes) {
        std::vector<int> trees, numbers, levels;
        for (std::size_t tree = 0; tree < _table.trees.size(); ++tree) {
            const Skeleton& skeleton = _simulation.skeleton(*_simulation.modelOf(_table.trees[tree]));
            for (std::size_t row = _table.firstRows[tree]; row < _table.firstRows[tree + 1]; ++row) {
                const std::size_t unit = _table.unitOf(row, tree);
                trees.push_back(static_cast<int>(tree));
                numbers.push_back(static_cast<int>(unit));
                levels.push_back(skeleton.units[unit].level);
            }
        }
        const auto define = [&](const char* name, const char* words, std::vector<int> values) {
            return defineFixed(name, NC_INT, units, words, std::move(values), writes);
        };
        const int index =
            define("tree_index", "place of the tree along the dimension tree", std::move(trees));
        _file.setAttribute(index, "instance_dimension", "tree");
        define("unit_number", "number of the unit in its tree, from 0", std::move(numbers));
        define("level", "branching order, 0 for the trunk", std::move(levels));
    }

    void defineColumns(int rows, std::size_t steps) {
        constexpr std::size_t mostBytes = 1 << 20, mostRows = 64;
        const std::size_t count = _table.rowCount();
        _stepsPerChunk = std::clamp<std::size_t>(mostBytes / sizeof(float) / std::max<std::size_t>(count, 1),
                                                 1, std::clamp<std::size_t>(steps, 1, 4096));
        _steps.resize(_table.columns.size());
        for (const MotionColumn& column : _table.columns) {
            const std::vector<int> dimensions =
                column.isFixed ? std::vector{rows} : std::vector{_timeDimension, rows};
            const int variable = _file.defineVariable(column.name.c_str(), NC_FLOAT, dimensions);
            _file.describe(variable, column.words, column.unit);
            _file.setAttribute(variable, "_FillValue", std::numeric_limits<float>::quiet_NaN());
            _file.setAttribute(variable, "coordinates",
                               _table.isOfUnits ? "tree_index unit_number level" : "id species x y z");
            if (_isOnMap)
                _file.setAttribute(variable, "grid_mapping", "crs");
            if (!column.isFixed)
                _file.compress(variable, {_stepsPerChunk, std::clamp<std::size_t>(count, 1, mostRows)});
            _variables.push_back(variable);
        }
    }

    void flush() {
        const std::size_t rows = _table.rowCount();
        if (!_times.empty())
            _file.write(_time, {_written}, {_times.size()}, _times.data());
        for (std::size_t c = 0; c < _variables.size() && !_times.empty(); ++c) {
            if (!_table.columns[c].isFixed)
                _file.write(_variables[c], {_written, 0}, {_times.size(), rows}, _steps[c].data());
            else if (_written == 0)
                _file.write(_variables[c], {0}, {rows}, _steps[c].data());
            _steps[c].clear();
        }
        _written += _times.size();
        _times.clear();
        checkFile();
    }

    const MotionTable& _table;
    const ForestSimulation& _simulation;
    AtomicFile _whole;
    NetCdfFile _file;
    bool _isOnMap = false;
    int _timeDimension = 0, _time = 0;
    double _start = 0.0;         ///< Of the simulation after the date of the variable `time`, s.
    std::vector<int> _variables; ///< By column.
    std::vector<float> _values;
    std::vector<double> _times;             ///< Of the steps that are not written yet.
    std::vector<std::vector<float>> _steps; ///< Their values, by column.
    std::size_t _stepsPerChunk = 1, _written = 0;
};

} // namespace

std::unique_ptr<MotionFile> createMotionNetCdf(const std::string& path, const MotionTable& table,
                                               const ForestSimulation& simulation, std::size_t steps) {
    return std::make_unique<MotionNetCdf>(path, table, simulation, steps);
}
