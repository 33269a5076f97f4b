// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFormats.h>

#include <osgTreeWind/base/InputFile.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/windfiles/WeatherHead.h>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// Arguments of a reader.
struct ReaderInput {
    const std::string& path;
    const WindRequest& request;
};

/// One format of wind data.
struct Format {
    const char* name;      ///< For messages.
    const char* extension; ///< Used if no format is recognised by content; null if there is none.
    bool (*begins)(std::string_view head); ///< Recognises the first kilobyte; null if it cannot.
    Result<WindContent> (*read)(const ReaderInput& source);
    bool hasVariables =
        false; ///< Whether a file may have several winds, of which WindRequest::variable names one.
};

bool startsWith(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// Adapts a reader of bytes, with some members of the request, to Format::read.
template <auto Read, auto... Options>
Result<WindContent> readAll(const ReaderInput& source) {
    const Result<std::string> bytes = readBytes(source.path);
    return bytes ? Read(bytes.value(), source.path, source.request.*Options...) : bytes.problems();
}

const Format windFormats[] = {
    {"ESRI ASCII", ".asc",
     [](std::string_view head) { return lower(std::string(head.substr(0, 5))) == "ncols"; },
     [](const ReaderInput& source) { return readEsriPair(source.path); }},
    {"GeoTIFF", nullptr,
     [](std::string_view head) {
         using namespace std::string_view_literals;
         return startsWith(head, "II*\0"sv) || startsWith(head, "MM\0*"sv) || startsWith(head, "II+\0"sv);
     },
     [](const ReaderInput& source) { return readTiffPair(source.path); }},
    {"VTK", nullptr, [](std::string_view head) { return startsWith(head, "# vtk DataFile"); },
     readAll<readVtkLegacy, &WindRequest::variable>, true},
    {"VTK", nullptr, [](std::string_view head) { return contains(head, "<VTKFile"); },
     readAll<readVtkXml, &WindRequest::variable>, true},
    {"TurbSim .bts", ".bts", nullptr, readAll<readTurbSim>},
    {"TOA5", nullptr, [](std::string_view head) { return startsWith(head, "\"TOA5\""); },
     readAll<readToa5, &WindRequest::columns>},
    {"EPW", nullptr, [](std::string_view head) { return startsWith(head, "LOCATION,"); }, readAll<readEpw>},
    {"NetCDF", nullptr, isNetCdf,
     [](const ReaderInput& source) { return readNetCdf(source.path, source.request); }, true},
    {"GRIB", nullptr, isGrib, [](const ReaderInput& source) { return readGrib(source.path, source.request); },
     true},
    {"QES sensor XML", ".xml", [](std::string_view head) { return contains(head, "<timeSeries"); },
     readAll<readQesSensor>},
    {".csv", ".csv", nullptr, readAll<readWindCsv, &WindRequest::columns>}};

const Format& csv = windFormats[std::size(windFormats) - 1];

/// Null if unknown.
const Format* findFormat(const std::string& path, std::string_view head, const WindSeriesColumns& columns) {
    const std::string extension = lower(extensionOf(path));
    for (const Format& format : windFormats)
        if (format.begins && format.begins(head))
            return &format;
    for (const Format& format : windFormats)
        if (format.extension && extension == format.extension)
            return &format;
    return columns.named() ? &csv : nullptr; // named columns imply a table
}

std::string formatNames() {
    std::string names;
    for (const Format& format : windFormats)
        if (!contains(names, format.name))
            names += (names.empty() ? "" : &format == &csv ? " or " : ", ") + std::string(format.name);
    return names;
}

} // namespace

Result<WindContent> readWindContent(const std::string& path, const WindRequest& request) {
    const Result<std::string> head = readHead(path, headSize);
    if (!head)
        return head.problems();
    const Format* format = findFormat(path, head.value(), request.columns);
    if (!format)
        return fileProblem(path, "unknown format of wind data; expected " + formatNames());
    if (!request.variable.empty() && !format->hasVariables)
        return keyProblem("variable",
                          std::string("a file of the format ") + format->name + " has only one wind");
    return format->read({path, request});
}

} // namespace osgTreeWind
