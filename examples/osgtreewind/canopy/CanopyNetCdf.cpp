// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyFile.h>

#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/places/GridMapping.h>
#include <osgTreeWind/species/SeasonDay.h>

#include <netcdf.h>

#include <algorithm>
#include <ctime>
#include <optional>

namespace {

using namespace osgTreeWind;

constexpr float noPlants = -9999.0f;

/// Coordinates of the middles of cells.
std::vector<double> middles(double low, double cell, int count) {
    std::vector<double> at;
    for (int i = 0; i < count; ++i)
        at.push_back(low + cell * (i + 0.5));
    return at;
}

/// Noon of the day of a season (0: midwinter, 4: a year later) in 2001, which has no 29 February.
std::string dateOf(float season) {
    std::tm start{};
    start.tm_year = 101;
    start.tm_mday = 1;
    const std::time_t noon = timegm(&start) + 86400 * std::time_t{dayOfSeason(season)} + 43200;
    std::tm date{};
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S +00", gmtime_r(&noon, &date))};
}

std::optional<Crs> mapOf(const CanopyHead& head) {
    const Result<Crs> crs = Crs::parseMap(head.crs);
    return head.crs.empty() || !crs ? std::nullopt : std::optional(crs.value());
}

/// Longitude and latitude of a place; 0 without a map projection.
glm::dvec2 degreesOf(glm::dvec2 place, const std::optional<Crs>& map) {
    if (!map)
        return glm::dvec2(0.0);
    const Result<CrsTransform> way = CrsTransform::between(*map, Crs::wgs84());
    return way && way.value().apply(place) ? place : glm::dvec2(0.0);
}

class NetCdfCanopy final : public CanopyFile {
public:
    ~NetCdfCanopy() override { close(); }
    NetCdfCanopy(const std::string& path, const CanopyHead& head, bool isPalm)
        : _cells(head.grid.cells), _isPalm(isPalm) {
        create(path);
        const CanopyGrid& grid = head.grid;
        const int levels = _cells.z + isPalm; // PALM's first level is the ground
        const std::vector<int> dimensions = {defineDimension(isPalm ? "zlad" : "z", levels),
                                             defineDimension("y", _cells.y), defineDimension("x", _cells.x)};
        const int z = defineVariable(isPalm ? "zlad" : "z", NC_DOUBLE, {dimensions[0]}),
                  y = defineVariable("y", NC_DOUBLE, {dimensions[1]}),
                  x = defineVariable("x", NC_DOUBLE, {dimensions[2]});
        const std::optional<Crs> map = mapOf(head);
        describeAxes(x, y, z, map && !isPalm);
        const int crs = map ? defineMap(*map) : -1;
        _leaf = defineField("lad", "leaf area density", dimensions, map.has_value());
        _drag = defineField("cda", "drag area density: Cd A of a force 0.5 rho Cd A U^2, in a m3 of air",
                            dimensions, map.has_value());
        describeFile(head, map);
        call(nc_enddef);
        if (map)
            write(crs, {0.0});
        const glm::dvec3 low = isPalm ? glm::dvec3(0.0) : grid.low;
        write(x, middles(low.x, grid.cell.x, _cells.x));
        write(y, middles(low.y, grid.cell.y, _cells.y));
        std::vector<double> heights = middles(grid.low.z, grid.cell.z, _cells.z);
        if (isPalm)
            heights.insert(heights.begin(), 0.0);
        write(z, heights);
    }

    bool write(const CanopyRow& row) override {
        writeRow(_leaf, row.row, row.leaf, row);
        writeRow(_drag, row.row, row.drag, row);
        return _problem.empty();
    }

    bool close() override {
        if (_open)
            check(nc_close(_file));
        _open = false;
        return _problem.empty();
    }

    std::string problem() const override { return _problem; }

private:
    void create(const std::string& path) {
        // All programs read the classic format with long offsets; its arrays are limited to 4 GiB.
        const double bytes = sizeof(float) * static_cast<double>(_cells.x) * _cells.y * (_cells.z + 1);
        check(
            nc_create(path.c_str(), NC_CLOBBER | (bytes < 4.0e9 ? NC_64BIT_OFFSET : NC_64BIT_DATA), &_file));
        _open = _problem.empty();
        int before = 0;
        call(nc_set_fill, NC_NOFILL, &before); // every value will be written
    }

    /// Remembers the first error.
    void check(int status) {
        if (status != NC_NOERR && _problem.empty())
            _problem = nc_strerror(status);
    }
    /// Calls a function of the library, unless there was an error.
    template <typename Function, typename... Arguments>
    void call(Function function, Arguments... arguments) {
        if (_problem.empty())
            check(function(_file, arguments...));
    }

    int defineDimension(const char* name, int size) {
        int id = 0;
        call(nc_def_dim, name, static_cast<std::size_t>(size), &id);
        return id;
    }
    int defineVariable(const char* name, int type, const std::vector<int>& dimensions) {
        int id = 0;
        call(nc_def_var, name, type, static_cast<int>(dimensions.size()), dimensions.data(), &id);
        return id;
    }
    void setAttribute(int variable, const char* name, const std::string& text) {
        call(nc_put_att_text, variable, name, text.size(), text.c_str());
    }
    void setAttribute(int variable, const char* name, const std::vector<double>& numbers) {
        call(nc_put_att_double, variable, name, NC_DOUBLE, numbers.size(), numbers.data());
    }
    void write(int variable, const std::vector<double>& numbers) {
        call(nc_put_var_double, variable, numbers.data());
    }

    void describeAxes(int x, int y, int z, bool onMap) {
        for (const auto& [variable, axis] : {std::pair(x, "x"), std::pair(y, "y")}) {
            const std::string name = axis;
            setAttribute(variable, "long_name",
                         _isPalm ? "distance to origin in " + name + "-direction"
                                 : name + " of the middle of the cell");
            if (onMap)
                setAttribute(variable, "standard_name", "projection_" + name + "_coordinate");
            setAttribute(variable, "units", "m");
            setAttribute(variable, "axis", name == "x" ? "X" : "Y");
        }
        setAttribute(z, "long_name", _isPalm ? "height above ground" : "height of the middle of the cell");
        setAttribute(z, "units", "m");
        setAttribute(z, "axis", "Z");
        setAttribute(z, "positive", "up");
    }

    int defineMap(const Crs& map) {
        const int crs = defineVariable("crs", NC_DOUBLE, {});
        const Result<GridMapping> described = gridMappingOf(map);
        const GridMapping mapping = described ? described.value() : GridMapping();
        setAttribute(crs, "long_name", "coordinate reference system");
        if (!mapping.name.empty())
            setAttribute(crs, "grid_mapping_name", mapping.name);
        for (const auto& [name, numbers] : mapping.numbers)
            setAttribute(crs, name.c_str(), numbers);
        setAttribute(crs, "crs_wkt", mapping.wkt);
        setAttribute(crs, "units", "m");
        if (const std::string text = map.text(); text.rfind("EPSG:", 0) == 0)
            setAttribute(crs, "epsg_code", text);
        return crs;
    }

    int defineField(const char* name, const char* words, const std::vector<int>& dimensions, bool onMap) {
        const int id = defineVariable(name, NC_FLOAT, dimensions);
        if (_isPalm)
            call(nc_put_att_float, id, "_FillValue", NC_FLOAT, std::size_t(1), &noPlants);
        setAttribute(id, "long_name", words);
        setAttribute(id, "units", "m2 m-3");
        if (onMap)
            setAttribute(id, "grid_mapping", "crs");
        return id;
    }

    void describeFile(const CanopyHead& head, const std::optional<Crs>& map) {
        constexpr int file = NC_GLOBAL;
        setAttribute(file, "Conventions", "CF-1.7");
        setAttribute(file, "title", "Leaf area and drag area of a forest");
        setAttribute(file, "source", "osgtreewind " OSGTREEWIND_VERSION);
        if (!_isPalm)
            return;
        const glm::dvec2 degrees = degreesOf(head.grid.low, map);
        setAttribute(file, "origin_x", std::vector{head.grid.low.x});
        setAttribute(file, "origin_y", std::vector{head.grid.low.y});
        setAttribute(file, "origin_z", std::vector{0.0});
        setAttribute(file, "origin_lon", std::vector{degrees.x});
        setAttribute(file, "origin_lat", std::vector{degrees.y});
        setAttribute(file, "origin_time", dateOf(head.season));
        setAttribute(file, "rotation_angle", std::vector{0.0});
    }

    /// Writes a row of an array. In PALM's format a column without plants has the fill value at each level.
    void writeRow(int variable, int row, const Span<float>& densities, const CanopyRow& all) {
        const auto width = static_cast<std::size_t>(_cells.x);
        const std::size_t levels = densities.size / width, ground = _isPalm ? 1 : 0;
        _levels.assign(ground * width, 0.0f);
        _levels.insert(_levels.end(), densities.begin(), densities.end());
        for (std::size_t x = 0; _isPalm && x < width; ++x) {
            bool isBare = true;
            for (std::size_t z = 0; z < levels && isBare; ++z)
                isBare = !(all.leaf[z * width + x] > 0.0f || all.drag[z * width + x] > 0.0f);
            for (std::size_t z = 0; z < levels + ground && isBare; ++z)
                _levels[z * width + x] = noPlants;
        }
        const std::size_t start[] = {0, static_cast<std::size_t>(row), 0},
                          count[] = {levels + ground, 1, width};
        call(nc_put_vara_float, variable, &start[0], &count[0], _levels.data());
    }

    glm::ivec3 _cells;
    bool _isPalm;
    int _file = 0, _leaf = 0, _drag = 0;
    bool _open = false;
    std::string _problem;
    std::vector<float> _levels;
};

} // namespace

std::unique_ptr<CanopyFile> createPalmCanopy(const std::string& path, const CanopyHead& head) {
    return std::make_unique<NetCdfCanopy>(path, head, true);
}

std::unique_ptr<CanopyFile> createCfCanopy(const std::string& path, const CanopyHead& head) {
    return std::make_unique<NetCdfCanopy>(path, head, false);
}
