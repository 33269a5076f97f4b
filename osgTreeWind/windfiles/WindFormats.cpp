// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/windfiles/NetCdfClassic.h>
#include <osgTreeWind/windfiles/QesSensor.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace osgTreeWind {

namespace {

namespace fs = std::filesystem;

Result<std::string> readBytes(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream bytes;
    std::error_code ignored;
    if (!file || fs::is_directory(path, ignored))
        return fileProblem(path, "cannot be read");
    bytes << file.rdbuf();
    if (bytes.str().empty())
        return fileProblem(path, "the file is empty");
    return bytes.str();
}

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

/// The name in the .prj beside a grid; empty without one.
std::string coordinatesBeside(const std::string& path) {
    std::ifstream file(fs::path(path).replace_extension(".prj"));
    std::string text, name;
    std::getline(file, text, '"');
    std::getline(file, name, '"');
    return name;
}

Result<WindContent> readEsriPair(const std::string& path) {
    const fs::path given(path);
    const std::string stem = given.stem().string(), extension = given.extension().string();
    const std::string end = stem.size() > 4 ? stem.substr(stem.size() - 4) : "";
    if (end != "_vel" && end != "_ang")
        return fileProblem(path, "expected the name to end in _vel" + extension + " or _ang" + extension +
                                     ", a pair of speed and direction");
    const std::string begin = (given.parent_path() / stem.substr(0, stem.size() - 4)).string();
    EsriGrid grids[2];
    const std::string paths[2] = {begin + "_vel" + extension, begin + "_ang" + extension};
    for (int i = 0; i < 2; ++i) {
        const Result<std::string> text = readBytes(paths[i]);
        if (!text)
            return text.problems();
        Result<EsriGrid> grid = readEsriGrid(text.value(), paths[i]);
        if (!grid)
            return grid.problems();
        grids[i] = std::move(grid.value());
    }
    Result<WindContent> content = windOfEsriGrids(grids[0], grids[1], path);
    if (content)
        content.value().summary.coordinates = coordinatesBeside(path);
    return content;
}

Result<WindContent> readQes(const std::string& bytes, const std::string& path) {
    std::istringstream text(bytes);
    Result<WindSeries> series = readQesSensor(text, path);
    if (!series)
        return series.problems();
    WindContent content;
    content.summary.format = "QES-Winds sensor";
    content.summary.unit = "m/s";
    content.summary.direction = "from, degrees clockwise from north";
    const LogProfile profile = series.value().profile.value_or(LogProfile{});
    content.summary.notes = {"measured " + numberText(profile.height) +
                             " m above ground of roughness length " + numberText(profile.roughness) +
                             " m; a logarithmic profile at other heights"};
    content.data = std::move(series.value());
    return content;
}

Result<WindContent> readCsv(const std::string& bytes, const std::string& path, WindSeriesColumns columns) {
    std::istringstream text(bytes);
    const Result<CsvTable> table = readCsvTable(text, path, columns.delimiter);
    if (!table)
        return table.problems();
    if (columns.time.empty()) {
        columns.time = "time";
        if (table.value().column("speed")) {
            columns.speed = "speed";
            columns.direction = "direction";
        } else {
            columns.u = "u";
            columns.v = "v";
            columns.w = table.value().column("w") ? "w" : "";
        }
    }
    columns.speedUnit = "m/s"; // converted with all other formats
    Result<WindSeries> series = windSeriesOf(table.value(), columns);
    if (!series)
        return series.problems();
    WindContent content;
    content.summary.format = "CSV";
    content.summary.direction = columns.speed.empty() ? "components toward east, north and up"
                                : columns.sense == DirectionSense::From
                                    ? "from, degrees clockwise from north"
                                    : "toward, degrees clockwise from north";
    content.data = std::move(series.value());
    return content;
}

} // namespace

std::string usualSpeedUnit(const std::string& text) {
    static const std::pair<const char*, const char*> names[] = {{"m s-1", "m/s"},
                                                                {"m s^-1", "m/s"},
                                                                {"m s**-1", "m/s"},
                                                                {"ms-1", "m/s"},
                                                                {"meters/second", "m/s"},
                                                                {"metres/second", "m/s"},
                                                                {"meters/sec", "m/s"},
                                                                {"mps", "m/s"},
                                                                {"meters per second", "m/s"},
                                                                {"meter/sec", "m/s"},
                                                                {"metre per second", "m/s"},
                                                                {"m/sec", "m/s"},
                                                                {"km h-1", "km/h"},
                                                                {"kph", "km/h"},
                                                                {"knots", "kn"},
                                                                {"knot", "kn"},
                                                                {"kt", "kn"},
                                                                {"kts", "kn"},
                                                                {"miles/hour", "mph"},
                                                                {"ft s-1", "ft/s"}};
    const std::string folded = lower(text);
    for (const auto& [name, unit] : names)
        if (folded == name)
            return unit;
    return text;
}

Result<WindContent> readWindContent(const std::string& path, const WindSeriesColumns& columns,
                                    bool asStored) {
    const Result<std::string> read = readBytes(path);
    if (!read)
        return read.problems();
    const std::string& bytes = read.value();
    const std::string extension = lower(fs::path(path).extension().string());
    if (startsWith(bytes, "# vtk DataFile"))
        return readVtkLegacy(bytes, path);
    if (startsWith(bytes, "CDF") || startsWith(bytes, "\x89HDF")) {
        const std::string damage = problemOfNetCdfHeader(bytes);
        return damage.empty() ? readNetCdf(path, asStored) : fileProblem(path, damage);
    }
    if (startsWith(bytes, "\"TOA5\""))
        return readToa5(bytes, path, columns);
    if (bytes.find("<VTKFile") < 1000)
        return readVtkXml(bytes, path);
    if (bytes.find("<timeSeries") != std::string::npos || extension == ".xml")
        return readQes(bytes, path);
    if (startsWith(lower(bytes.substr(0, 5)), "ncols") || extension == ".asc")
        return readEsriPair(path);
    if (extension == ".bts")
        return readTurbSim(bytes, path);
    if (extension == ".csv")
        return readCsv(bytes, path, columns);
    return fileProblem(
        path, "no known format of wind data; expected ESRI ASCII, VTK, TurbSim .bts, TOA5, NetCDF, QES "
              "sensor XML or .csv");
}

} // namespace osgTreeWind
