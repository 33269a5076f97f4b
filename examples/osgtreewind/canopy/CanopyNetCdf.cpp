// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyFile.h>
#include <examples/osgtreewind/output/NetCdfOutput.h>

#include <osgTreeWind/places/CrsWay.h>
#include <osgTreeWind/places/GridMapping.h>
#include <osgTreeWind/species/Season.h>

#include <algorithm>
#include <ctime>
#include <optional>

namespace {

using namespace osgTreeWind;

constexpr float noPlants = -9999.0f;

/// Middles of cells.
std::vector<double> middles(double low, double cell, int count) {
    std::vector<double> at;
    for (int i = 0; i < count; ++i)
        at.push_back(low + cell * (i + 0.5));
    return at;
}

/// Noon of the day of a season (0: midwinter, 4: a year later), in a year that has no 29 February.
std::string dateOf(float season) {
    std::tm start{};
    start.tm_year = 101;
    start.tm_mday = 1;
    const double midwinterDay = 34.5; // noon of 4 February
    const double day = midwinterDay + 0.25 * static_cast<double>(withinYear(season)) * 365.25;
    const std::time_t noon = timegm(&start) + 86400 * (static_cast<std::time_t>(day) % 365) + 43200;
    std::tm date{};
    char text[32];
    return {text, std::strftime(text, sizeof text, "%Y-%m-%d %H:%M:%S +00", gmtime_r(&noon, &date))};
}

std::optional<Crs> mapOf(const CanopyHead& head) {
    const Result<Crs> crs = Crs::parseMap(head.crs);
    return head.crs.empty() || !crs ? std::nullopt : std::optional(crs.value());
}

/// Longitude and latitude of a place; without a map 0.
glm::dvec2 degreesOf(glm::dvec2 place, const std::optional<Crs>& map) {
    if (!map)
        return glm::dvec2(0.0);
    const Result<CrsWay> way = CrsWay::between(*map, Crs::degrees());
    return way && way.value().go(place) ? place : glm::dvec2(0.0);
}

class NetCdfCanopy : public CanopyFile {
public:
    NetCdfCanopy(const std::string& path, const CanopyHead& head, bool isPalm)
        : _cells(head.grid.cells), _isPalm(isPalm),
          _file(path, sizeof(float) * static_cast<double>(_cells.x) * _cells.y * (_cells.z + 1)) {
        const CanopyGrid& grid = head.grid;
        const int levels = _cells.z + isPalm; // PALM's first level is the ground
        const std::vector<int> dimensions = {_file.dimension(isPalm ? "zlad" : "z", levels),
                                             _file.dimension("y", _cells.y), _file.dimension("x", _cells.x)};
        const int z = _file.coordinates(isPalm ? "zlad" : "z", {dimensions[0]}),
                  y = _file.coordinates("y", {dimensions[1]}), x = _file.coordinates("x", {dimensions[2]});
        const std::optional<Crs> map = mapOf(head);
        sayAxes(x, y, z, map && !isPalm);
        const int crs = map ? sayMap(*map) : -1;
        _leaf = field("lad", "leaf area density", dimensions, map.has_value());
        _drag = field("cda", "drag area density: Cd A of a force 0.5 rho Cd A U^2, in a m3 of air",
                      dimensions, map.has_value());
        sayFile(head, map);
        _file.endDefinitions();
        if (map)
            _file.write(crs, {0.0});
        const glm::dvec3 low = isPalm ? glm::dvec3(0.0) : grid.low;
        _file.write(x, middles(low.x, grid.cell.x, _cells.x));
        _file.write(y, middles(low.y, grid.cell.y, _cells.y));
        std::vector<double> heights = middles(grid.low.z, grid.cell.z, _cells.z);
        if (isPalm)
            heights.insert(heights.begin(), 0.0);
        _file.write(z, heights);
    }

    bool write(const CanopyRow& row) override {
        put(_leaf, row.row, row.leaf, row);
        put(_drag, row.row, row.drag, row);
        return problem().empty();
    }

    bool close() override {
        _file.close();
        return problem().empty();
    }

    std::string problem() const override { return _file.problem(); }

private:
    void sayAxes(int x, int y, int z, bool onMap) {
        for (const auto& [array, axis] : {std::pair(x, "x"), std::pair(y, "y")}) {
            const std::string name = axis;
            _file.attribute(array, "long_name",
                            _isPalm ? "distance to origin in " + name + "-direction"
                                    : name + " of the middle of the cell");
            if (onMap)
                _file.attribute(array, "standard_name", "projection_" + name + "_coordinate");
            _file.attribute(array, "units", std::string("m"));
            _file.attribute(array, "axis", std::string(name == "x" ? "X" : "Y"));
        }
        _file.attribute(z, "long_name",
                        std::string(_isPalm ? "height above ground" : "height of the middle of the cell"));
        _file.attribute(z, "units", std::string("m"));
        _file.attribute(z, "axis", std::string("Z"));
        _file.attribute(z, "positive", std::string("up"));
    }

    int sayMap(const Crs& map) {
        const int crs = _file.coordinates("crs", {});
        const Result<GridMapping> described = gridMappingOf(map);
        const GridMapping mapping = described ? described.value() : GridMapping();
        _file.attribute(crs, "long_name", std::string("coordinate reference system"));
        if (!mapping.name.empty())
            _file.attribute(crs, "grid_mapping_name", mapping.name);
        for (const auto& [name, numbers] : mapping.numbers)
            _file.attribute(crs, name.c_str(), numbers);
        _file.attribute(crs, "crs_wkt", mapping.wkt);
        _file.attribute(crs, "units", std::string("m"));
        if (const std::string text = map.text(); text.rfind("EPSG:", 0) == 0)
            _file.attribute(crs, "epsg_code", text);
        return crs;
    }

    int field(const char* name, const char* words, const std::vector<int>& dimensions, bool onMap) {
        const int array = _file.field(name, dimensions);
        if (_isPalm)
            _file.attribute(array, "_FillValue", noPlants);
        _file.attribute(array, "long_name", std::string(words));
        _file.attribute(array, "units", std::string("m2 m-3"));
        if (onMap)
            _file.attribute(array, "grid_mapping", std::string("crs"));
        return array;
    }

    void sayFile(const CanopyHead& head, const std::optional<Crs>& map) {
        constexpr int file = NetCdfOutput::wholeFile;
        _file.attribute(file, "Conventions", std::string("CF-1.7"));
        _file.attribute(file, "title", std::string("Leaf area and drag area of a forest"));
        _file.attribute(file, "source", std::string("osgtreewind " OSGTREEWIND_VERSION));
        if (!_isPalm)
            return;
        const glm::dvec2 degrees = degreesOf(head.grid.low, map);
        _file.attribute(file, "origin_x", std::vector{head.grid.low.x});
        _file.attribute(file, "origin_y", std::vector{head.grid.low.y});
        _file.attribute(file, "origin_z", std::vector{0.0});
        _file.attribute(file, "origin_lon", std::vector{degrees.x});
        _file.attribute(file, "origin_lat", std::vector{degrees.y});
        _file.attribute(file, "origin_time", dateOf(head.season));
        _file.attribute(file, "rotation_angle", std::vector{0.0});
    }

    /// In PALM's files a column without plants has the fill value at each level.
    void put(int array, int row, const Span<float>& densities, const CanopyRow& all) {
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
        _file.write(array, {0, static_cast<std::size_t>(row), 0}, {levels + ground, 1, width},
                    _levels.data());
    }

    glm::ivec3 _cells;
    bool _isPalm;
    NetCdfOutput _file;
    int _leaf = 0, _drag = 0;
    std::vector<float> _levels;
};

} // namespace

std::unique_ptr<CanopyFile> createPalmCanopy(const std::string& path, const CanopyHead& head) {
    return std::make_unique<NetCdfCanopy>(path, head, true);
}

std::unique_ptr<CanopyFile> createCfCanopy(const std::string& path, const CanopyHead& head) {
    return std::make_unique<NetCdfCanopy>(path, head, false);
}
