// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyFile.h>
#include <examples/osgtreewind/output/NetCdfFile.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/places/CrsTransform.h>
#include <osgTreeWind/species/SeasonDay.h>

#include <algorithm>
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
    constexpr double newYear = 978307200.0, day = 86400.0; // seconds
    const std::string time = isoTimeText(newYear + day * (dayOfSeason(season) + 0.5));
    return time.substr(0, 10) + ' ' + time.substr(11, 8) + " +00";
}

std::optional<Crs> mapOf(const CanopyHead& head) {
    const Result<Crs> crs = Crs::parseMap(head.crs);
    return head.crs.empty() || !crs ? std::nullopt : std::optional(crs.value());
}

class NetCdfCanopy final : public CanopyFile {
public:
    NetCdfCanopy(const std::string& path, const CanopyHead& head, bool isPalm)
        : _cells(head.grid.cells), _isPalm(isPalm), _file(path, formatFor(_cells)) {
        const CanopyGrid& grid = head.grid;
        const int levels = _cells.z + isPalm; // PALM's first level is the ground
        const char* const height = isPalm ? "zlad" : "z";
        const auto dimension = [&](const char* name, int size) {
            return _file.defineDimension(name, static_cast<std::size_t>(size));
        };
        const std::vector<int> dimensions = {dimension(height, levels), dimension("y", _cells.y),
                                             dimension("x", _cells.x)};
        const int z = _file.defineVariable(height, NC_DOUBLE, {dimensions[0]}),
                  y = _file.defineVariable("y", NC_DOUBLE, {dimensions[1]}),
                  x = _file.defineVariable("x", NC_DOUBLE, {dimensions[2]});
        const std::optional<Crs> map = mapOf(head);
        describeAxes(x, y, z, map && !isPalm);
        const int crs = map ? _file.defineMap(*map) : -1;
        _leaf = defineField("lad", "leaf area density", dimensions, map.has_value());
        _drag = defineField("cda", "drag area density: Cd A of a force 0.5 rho Cd A U^2, in a m3 of air",
                            dimensions, map.has_value());
        describeFile(head, map);
        _file.endDefinitions();
        if (map)
            _file.write(crs, std::vector{0.0});
        const glm::dvec3 low = isPalm ? glm::dvec3(0.0) : grid.low;
        _file.write(x, middles(low.x, grid.cell.x, _cells.x));
        _file.write(y, middles(low.y, grid.cell.y, _cells.y));
        std::vector<double> heights = middles(grid.low.z, grid.cell.z, _cells.z);
        if (isPalm)
            heights.insert(heights.begin(), 0.0);
        _file.write(z, heights);
    }

    bool write(const CanopyRow& row) override {
        writeRow(_leaf, row.row, row.leaf, row);
        writeRow(_drag, row.row, row.drag, row);
        return _file.problem().empty();
    }

    bool close() override { return _file.close(); }
    std::string problem() const override { return _file.problem(); }

private:
    /// All programs read the classic format with long offsets; its arrays are limited to 4 GiB.
    static int formatFor(const glm::ivec3& cells) {
        const double bytes = sizeof(float) * static_cast<double>(cells.x) * cells.y * (cells.z + 1);
        return bytes < 4.0e9 ? NC_64BIT_OFFSET : NC_64BIT_DATA;
    }

    void describeAxes(int x, int y, int z, bool onMap) {
        for (const auto& [variable, axis] : {std::pair(x, "x"), std::pair(y, "y")}) {
            const std::string name = axis;
            _file.setAttribute(variable, "long_name",
                               _isPalm ? "distance to origin in " + name + "-direction"
                                       : name + " of the middle of the cell");
            if (onMap)
                _file.setAttribute(variable, "standard_name", "projection_" + name + "_coordinate");
            _file.setAttribute(variable, "units", "m");
            _file.setAttribute(variable, "axis", name == "x" ? "X" : "Y");
        }
        _file.setAttribute(z, "long_name",
                           _isPalm ? "height above ground" : "height of the middle of the cell");
        _file.setAttribute(z, "units", "m");
        _file.setAttribute(z, "axis", "Z");
        _file.setAttribute(z, "positive", "up");
    }

    int defineField(const char* name, const char* words, const std::vector<int>& dimensions, bool onMap) {
        const int id = _file.defineVariable(name, NC_FLOAT, dimensions);
        if (_isPalm)
            _file.setAttribute(id, "_FillValue", noPlants);
        _file.describe(id, words, "m2 m-3");
        if (onMap)
            _file.setAttribute(id, "grid_mapping", "crs");
        return id;
    }

    void describeFile(const CanopyHead& head, const std::optional<Crs>& map) {
        constexpr int file = NetCdfFile::global;
        _file.describeFile("Leaf area and drag area of a forest");
        if (!_isPalm)
            return;
        const glm::dvec2 low(head.grid.low), zero(0.0); // without a map projection
        const glm::dvec2 degrees = map ? longitudeLatitudeOf(low, *map).value_or(zero) : zero;
        _file.setAttribute(file, "origin_x", std::vector{head.grid.low.x});
        _file.setAttribute(file, "origin_y", std::vector{head.grid.low.y});
        _file.setAttribute(file, "origin_z", std::vector{0.0});
        _file.setAttribute(file, "origin_lon", std::vector{degrees.x});
        _file.setAttribute(file, "origin_lat", std::vector{degrees.y});
        _file.setAttribute(file, "origin_time", dateOf(head.season));
        _file.setAttribute(file, "rotation_angle", std::vector{0.0});
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
        _file.write(variable, {0, static_cast<std::size_t>(row), 0}, {levels + ground, 1, width},
                    _levels.data());
    }

    glm::ivec3 _cells;
    bool _isPalm;
    NetCdfFile _file;
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
