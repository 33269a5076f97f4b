// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/windfiles/WeatherHead.h>
#include <osgTreeWind/windfiles/WindInput.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// What a reader is given.
struct Given {
    WindInput& input;
    const WindRequest& request;
};

/// One format of wind data.
struct Format {
    const char* name;      ///< For people.
    const char* extension; ///< Of a file that is taken for one where no beginning tells; null for none.
    bool (*begins)(std::string_view head); ///< Whether a file with this first kilobyte is one; null: never.
    Result<WindContent> (*read)(const Given& given);
};

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

bool holds(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// The reader of a format over bytes.
template <Result<WindContent> (*Read)(std::string_view, const std::string&)>
Result<WindContent> readAll(const Given& given) {
    const Result<std::string> bytes = given.input.bytes();
    return bytes ? Read(bytes.value(), given.input.path()) : bytes.problems();
}

template <Result<WindContent> (*Read)(std::string_view, const std::string&, const WindSeriesColumns&)>
Result<WindContent> readTable(const Given& given) {
    const Result<std::string> bytes = given.input.bytes();
    return bytes ? Read(bytes.value(), given.input.path(), given.request.columns) : bytes.problems();
}

const Format windFormats[] = {
    {"ESRI ASCII", ".asc",
     [](std::string_view head) { return lower(std::string(head.substr(0, 5))) == "ncols"; },
     [](const Given& given) { return readEsriPair(given.input.path()); }},
    {"GeoTIFF", nullptr,
     [](std::string_view head) {
         using namespace std::string_view_literals;
         return startsWith(head, "II*\0"sv) || startsWith(head, "MM\0*"sv) || startsWith(head, "II+\0"sv);
     },
     [](const Given& given) { return readTiffPair(given.input.path()); }},
    {"VTK", nullptr, [](std::string_view head) { return startsWith(head, "# vtk DataFile"); },
     readAll<readVtkLegacy>},
    {"VTK", nullptr, [](std::string_view head) { return holds(head, "<VTKFile"); }, readAll<readVtkXml>},
    {"TurbSim .bts", ".bts", nullptr, readAll<readTurbSim>},
    {"TOA5", nullptr, [](std::string_view head) { return startsWith(head, "\"TOA5\""); },
     readTable<readToa5>},
    {"EPW", nullptr, [](std::string_view head) { return startsWith(head, "LOCATION,"); }, readAll<readEpw>},
    {"NetCDF", nullptr, beginsNetCdf,
     [](const Given& given) { return readNetCdf(given.input.path(), given.request); }},
    {"GRIB", nullptr, beginsGrib,
     [](const Given& given) { return readGrib(given.input.path(), given.request); }},
    {"QES sensor XML", ".xml", [](std::string_view head) { return holds(head, "<timeSeries"); },
     readAll<readQesSensor>},
    {".csv", ".csv", nullptr, readTable<readWindCsv>}};

const Format& csv = windFormats[std::size(windFormats) - 1];

/// Null for none.
const Format* formatOf(const std::string& path, std::string_view head, const WindSeriesColumns& columns) {
    const std::string extension = lower(std::filesystem::path(path).extension().string());
    for (const Format& format : windFormats)
        if (format.begins && format.begins(head))
            return &format;
    for (const Format& format : windFormats)
        if (format.extension && extension == format.extension)
            return &format;
    return columns.named() ? &csv : nullptr; // a table, as whoever names its columns knows
}

std::string namesOfFormats() {
    std::string names;
    for (const Format& format : windFormats)
        if (!holds(names, format.name))
            names += (names.empty() ? "" : &format == &csv ? " or " : ", ") + std::string(format.name);
    return names;
}

} // namespace

Result<WindContent> readWindContent(const std::string& path, const WindRequest& request) {
    WindInput input(path);
    const Result<std::string> head = input.head();
    if (!head)
        return head.problems();
    if (const Format* format = formatOf(path, head.value(), request.columns))
        return format->read({input, request});
    return fileProblem(path, "no known format of wind data; expected " + namesOfFormats());
}

} // namespace osgTreeWind
