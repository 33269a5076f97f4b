// SPDX-License-Identifier: MIT
#include <plugins/weather/GribWind.h>

#include <plugins/weather/GribChoice.h>
#include <plugins/weather/GribValues.h>
#include <plugins/weather/PointColumn.h>
#include <plugins/weather/TrueNorth.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/wind/WindDirection.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <glm/trigonometric.hpp>

#include <cpl_virtualmem.h>
#include <cpl_vsi.h>

#include <cmath>
#include <deque>
#include <filesystem>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <system_error>

namespace osgTreeWind {

namespace {

using Numbers = std::vector<float>;
constexpr float missingValue = std::numeric_limits<float>::quiet_NaN();

void increaseUpward(const PointColumn& column) {
    constexpr float minStep = 0.01f; // metres; resolved by floats up to 100 km
    std::size_t known = column.lowestWhere([](float height) { return std::isfinite(height); });
    if (known == column.layers)
        column.height(known = 0) = 0.0f;
    for (std::size_t layer = known; layer > 0; --layer)
        column.height(layer - 1) = column.height(layer) - minStep;
    for (std::size_t layer = known + 1; layer < column.layers; ++layer)
        if (const float least = column.height(layer - 1) + minStep; !(column.height(layer) >= least))
            column.height(layer) = least;
}

/// Makes heights increase upward in each column, as GridWind requires. A level that has no height, or is not
/// above the previous one, is placed 1 cm above it.
///
/// If heights are above ground, levels below the ground (extrapolated by the model) or without a height get
/// the wind of the lowest level above the ground.
/// @param grid with heights (NaN if missing) and values for each point and time.
void makeHeightsIncrease(GridWind::Grid& grid) {
    forEachColumn(grid, [&](const PointColumn& column) {
        column.replaceWindUpTo(grid.aboveGround ? 0.0f : -1e9f);
        increaseUpward(column);
    });
}

class GribReader {
public:
    GribReader(std::string path, double bytes, GribChoice choice, const WindRequest& request)
        : _path(std::move(path)), _bytes(bytes), _choice(std::move(choice)), _request(request),
          _values(_path) {}

    Result<WindContent> read() {
        checkGrids();
        setGrid();
        readHeights();
        readVelocities();
        turn();
        if (_problem)
            return *_problem;
        WindSummary& summary = _content.summary;
        summary.format = "GRIB" + std::to_string(first().parameter.edition);
        summary.unit = "m/s";
        summary.start = isoTimeText(_choice.times.front());
        for (const double time : _choice.times)
            if (_choice.times.size() > 1)
                _grid.times.push_back(time - _choice.times.front());
        summary.notes.insert(summary.notes.begin(), _choice.notes.begin(), _choice.notes.end());
        _content.data = std::move(_grid);
        return std::move(_content);
    }

private:
    const GribField& first() const { return *_choice.east.front(); }
    std::size_t layers() const { return _choice.levels.size(); }
    std::size_t steps() const { return _choice.times.size(); }

    void fail(const Diagnostic& problem) {
        if (!_problem)
            _problem = problem;
    }

    void checkGrids() {
        for (const GribField* field : _choice.allFields())
            if (field->grid.definition != first().grid.definition)
                fail(fileProblem(_path, textOf(first()) + " and " + textOf(*field) +
                                            " lie on different grids, " + sizeOf(first()) + " and " +
                                            sizeOf(*field)));
        for (const auto* component : {&_choice.east, &_choice.north})
            for (const GribField* field : *component)
                if (field->grid.relativeToGrid != first().grid.relativeToGrid)
                    fail(
                        fileProblem(_path, textOf(first()) + " and " + textOf(*field) +
                                               " are relative to different norths: one to true north, one to "
                                               "the grid's north"));
    }

    static std::string sizeOf(const GribField& field) {
        return field.grid.kind + " of " + std::to_string(field.grid.columns) + " x " +
               std::to_string(field.grid.rows);
    }

    void setGrid() {
        if (_problem)
            return;
        constexpr double maxPoints = 1u << 27; // per field, which ecCodes reads at once
        const GribGrid& grid = first().grid;
        if (grid.isEven && static_cast<double>(grid.columns) * static_cast<double>(grid.rows) > maxPoints)
            return fail(fileProblem(_path, "expected at most " + numberText(maxPoints) + " points, found " +
                                               sizeOf(first())));
        const Result<GribGeoreference> found = _values.georeference(first());
        if (!found)
            return fail(found.problems().front());
        _crs = found.value().crs;
        _content.summary.crs = _crs.text();
        _content.summary.coordinates = found.value().name;
        const Result<GridPart> part =
            gridPartFor(_request, _content.summary.crs, found.value().x, found.value().y);
        if (!part)
            return fail({_path, 0, 0, part.problems().front().key, part.problems().front().message});
        _content.fileExtent = part.value().fileExtent;
        _x = part.value().x;
        _y = part.value().y;
        checkSize();
        _grid.points = {static_cast<int>(_x.indices.size()), static_cast<int>(_y.indices.size()),
                        static_cast<int>(layers())};
        _grid.origin = {_x.first, _y.first, 0.0};
        _grid.cell = {_x.step, _y.step, 1.0};
    }

    /// Checks the size before memory is allocated.
    void checkSize() {
        const double points = static_cast<double>(_x.indices.size()) *
                              static_cast<double>(_y.indices.size()) * static_cast<double>(layers()) *
                              static_cast<double>(steps()),
                     most = (1u << 25) + 4.0 * _bytes;
        if (points > most)
            fail(fileProblem(_path, "expected at most " + numberText(most) + " velocities, found " +
                                        numberText(points) + " (" + std::to_string(_x.indices.size()) +
                                        " x " + std::to_string(_y.indices.size()) + " points, " +
                                        std::to_string(layers()) + " levels, " + std::to_string(steps()) +
                                        " times)"));
    }

    std::size_t perLayer() const { return _x.indices.size() * _y.indices.size(); }

    Numbers numbersOf(const GribField& field) {
        if (_problem)
            return {};
        Result<Numbers> numbers = _values.read(field, _x, _y);
        if (!numbers) {
            fail(numbers.problems().front());
            return {};
        }
        return std::move(numbers.value());
    }

    Numbers heightsOf(const GribField& field) {
        const double metres = GribMeaning::of(field).metres;
        Numbers numbers = numbersOf(field);
        for (float& number : numbers)
            number = static_cast<float>(number * metres);
        return numbers;
    }

    void readHeights() {
        if (_problem)
            return;
        const GribLevelKind kind = _choice.levels.front().kind;
        _grid.aboveGround = kind == GribLevelKind::AboveGround || _choice.ground;
        const bool isKnown = kind == GribLevelKind::AboveGround || kind == GribLevelKind::AboveSea;
        if (isKnown && !_choice.ground)
            for (const GribLevel& level : _choice.levels)
                _grid.heights.push_back(static_cast<float>(level.value));
        else if (isKnown || !_choice.height.empty())
            readHeightsOfPoints();
    }

    void readHeightsOfPoints() {
        _hasHeightsOfPoints = true;
        if (!_choice.height.empty() && layers() > 1)
            _downward =
                meanOf(heightsOf(*_choice.height[0])) > meanOf(heightsOf(*_choice.height[layers() - 1]));
        const Numbers ground = _choice.ground ? heightsOf(*_choice.ground) : Numbers(perLayer(), 0.0f);
        const std::size_t times = _choice.height.empty() ? 1 : steps();
        _grid.heights.reserve(times * layers() * perLayer());
        for (std::size_t step = 0; step < times && !_problem; ++step)
            for (std::size_t layer = 0; layer < layers() && !_problem; ++layer) {
                const Numbers above =
                    _choice.height.empty()
                        ? Numbers(perLayer(), static_cast<float>(_choice.levels[layer].value))
                        : heightsOf(*_choice.height[indexOf(step, layer)]);
                for (std::size_t i = 0; i < above.size() && !_problem; ++i)
                    _grid.heights.push_back(above[i] - ground[i]);
            }
    }

    static double meanOf(const Numbers& numbers) {
        double sum = 0.0, count = 0.0;
        for (const float number : numbers)
            if (std::isfinite(number)) {
                sum += number;
                ++count;
            }
        return count > 0.0 ? sum / count : 0.0;
    }

    /// Index in GribChoice of a layer counted upward.
    std::size_t indexOf(std::size_t step, std::size_t layer) const {
        return _choice.indexOf(step, _downward ? layers() - 1 - layer : layer);
    }

    void readVelocities() {
        if (_problem)
            return;
        _grid.values.reserve(3 * steps() * layers() * perLayer());
        for (std::size_t step = 0; step < steps(); ++step)
            for (std::size_t layer = 0; layer < layers() && !_problem; ++layer)
                readLayer(indexOf(step, layer));
        if (!_problem && _hasHeightsOfPoints)
            repeatHeights();
    }

    void readLayer(std::size_t index) {
        const GribField &east = *_choice.east[index], &north = *_choice.north[index];
        const Numbers a = numbersOf(east), b = numbersOf(north),
                      w = _choice.up.empty() ? Numbers(a.size(), 0.0f) : numbersOf(*_choice.up[index]);
        for (std::size_t i = 0; i < a.size() && !_problem; ++i) {
            glm::vec3 velocity(a[i], b[i], w[i]);
            if (_choice.isPolar && (a[i] < 0.0f || std::abs(b[i]) > maxDirection))
                fail({_path, 0, 0, textOf(north),
                      "expected speeds not below 0 and directions of -360 to 360, found " + numberText(a[i]) +
                          " and " + numberText(b[i])});
            else if (std::isnan(a[i]) || std::isnan(b[i]) || std::isnan(w[i]))
                velocity = glm::vec3(missingValue);
            else if (_choice.isPolar)
                velocity = windVelocity({a[i], glm::radians(b[i])}, DirectionSense::From);
            _grid.values.insert(_grid.values.end(), {velocity.x, velocity.y, velocity.z});
        }
    }

    /// Repeats heights for all times, so that makeHeightsIncrease() can change each column.
    void repeatHeights() {
        const std::size_t once = layers() * perLayer();
        for (std::size_t step = 1; step < steps() && _grid.heights.size() < steps() * once; ++step)
            _grid.heights.insert(_grid.heights.end(), _grid.heights.begin(),
                                 _grid.heights.begin() + static_cast<std::ptrdiff_t>(once));
        makeHeightsIncrease(_grid);
    }

    /// Turns velocities from true north to the y axis of the projection, or only adds a note if they are
    /// wanted as stored. Directions are always relative to true north.
    void turn() {
        const bool fromTrueNorth = _choice.isPolar || !first().grid.relativeToGrid || _crs.isDegrees();
        std::string& direction = _content.summary.direction;
        direction = _choice.isPolar ? "from, degrees clockwise from true north"
                    : fromTrueNorth ? "components toward true east, true north and up"
                                    : "components toward x (east), y (north) and up";
        if (_problem || !fromTrueNorth || _crs.isDegrees())
            return;
        if (const auto note = turnFromTrueNorth(_grid, _crs, _request.asStored))
            _content.summary.notes.push_back(*note);
        else
            fail({_path, 0, 0, textOf(first()), "its CRS does not cover its points"});
    }

    std::string _path;
    double _bytes;
    GribChoice _choice;
    const WindRequest& _request;
    GribValues _values;
    Crs _crs;
    AxisPart _x, _y;
    bool _downward = false, _hasHeightsOfPoints = false;
    GridWind::Grid _grid;
    WindContent _content;
    std::optional<Diagnostic> _problem;
};

/// A file, memory-mapped where GDAL can.
class MappedFile {
public:
    explicit MappedFile(const std::string& path)
        : _file(VSIFOpenL(path.c_str(), "rb"), &VSIFCloseL), _memory(nullptr, &CPLVirtualMemFree) {
        std::error_code problem;
        const auto size = std::filesystem::file_size(toPath(path), problem);
        if (_file && !problem)
            _memory.reset(
                CPLVirtualMemFileMapNew(_file.get(), 0, size, VIRTUALMEM_READONLY, nullptr, nullptr));
        if (_memory)
            _bytes = {static_cast<const char*>(CPLVirtualMemGetAddr(_memory.get())), size};
        else if (Result<std::string> read = readBytes(path)) {
            _read = std::move(read.value());
            _bytes = _read;
        }
    }
    std::string_view bytes() const { return _bytes; } ///< Empty if it cannot be read.

private:
    std::unique_ptr<VSILFILE, decltype(&VSIFCloseL)> _file;
    std::unique_ptr<CPLVirtualMem, decltype(&CPLVirtualMemFree)> _memory;
    std::string _read;
    std::string_view _bytes;
};

} // namespace

Result<WindContent> readGribWind(const std::string& path, const WindRequest& request) {
    std::vector<std::string> paths = {path};
    if (!request.secondFile.empty())
        paths.push_back(request.secondFile);
    std::deque<MappedFile> files; // must outlive the fields
    std::vector<GribField> fields;
    double size = 0.0;
    for (const std::string& each : paths) {
        const std::string_view bytes = files.emplace_back(each).bytes();
        if (bytes.empty())
            return fileProblem(each, "cannot be read");
        Result<std::vector<GribField>> some = readGribFields(bytes, each);
        if (!some)
            return some.problems();
        std::move(some.value().begin(), some.value().end(), std::back_inserter(fields));
        size += static_cast<double>(bytes.size());
    }
    const Result<GribChoice> choice = chooseGribWind(fields, path, request.variable);
    if (!choice)
        return choice.problems();
    return GribReader(path, size, choice.value(), request).read();
}

} // namespace osgTreeWind
