// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ReadWindData.h>

#include <osgTreeWind/base/IsoTime.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/wind/WindParts.h>
#include <osgTreeWind/windfiles/WindFile.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace osgTreeWind {

std::optional<double> readSpeedUnit(TableReader& table, const std::string& key, std::string& name) {
    name = "m/s";
    table.read(key, name);
    const auto unit = speedUnit(name);
    if (unit.ok())
        return unit.value();
    table.problem(key, unit.problems().front().message);
    return std::nullopt;
}

void reportWind(const Diagnostics& problems, TableReader& table, ForestReading& reading) {
    for (const Diagnostic& problem : problems) {
        if (problem.file.empty())
            table.problem(table.has(problem.key) ? problem.key : "", problem.message);
        else
            reading.log.add(problem);
    }
}

namespace {

/// The paths of `file`, or of all `files` with their `times`. False after a problem.
bool readDataPaths(TableReader& table, ForestReading& reading, std::vector<std::string>& paths,
                   std::vector<double>& times) {
    std::string name;
    std::vector<std::string> names;
    const bool one = table.read("file", name), several = table.read("files", names),
               timed = table.read("times", times);
    const auto refuse = [&](const char* key, const char* why) {
        table.problem(key, why);
        return false;
    };
    if (table.has("file") && table.has("files"))
        return refuse("files", "give either this or file");
    if (table.has("times") && !table.has("files"))
        return refuse("times", "expected only beside files");
    if (!table.has("file") && !table.has("files"))
        return table.missing("file");
    if (!one && !(several && (timed || !table.has("times"))))
        return false; // not what they should be, as the log says
    for (const std::string& each : one ? std::vector<std::string>{name} : names) {
        const auto file = reading.open(table, one ? "file" : "files", each);
        if (!file)
            return false;
        paths.push_back(file->path);
    }
    return true;
}

/// "x 385000 to 385700, y 5818000 to 5818500".
std::string extentText(const WindExtent& extent, const glm::dvec3& offset) {
    const auto rounded = [](double metres) { return numberText(std::round(100.0 * metres) / 100.0); };
    std::string text;
    for (int axis = 0; axis < 2; ++axis)
        if (!extent.isEverywhere(axis))
            text += std::string(text.empty() ? "" : ", ") + (axis == 0 ? "x " : "y ") +
                    rounded(extent.low[axis] + offset[axis]) + " to " +
                    rounded(extent.high[axis] + offset[axis]);
    return text;
}

/// How many places of trees a wind does not cover, and how many there are; of a forest in tiles, of its
/// rectangle.
std::pair<std::size_t, std::size_t> countOutside(const WindFile& file, ForestReading& reading) {
    const glm::dvec3& origin = reading.forest.origin;
    std::size_t outside = 0, all = 0;
    const auto take = [&](const glm::dvec2& place) {
        outside += !file.covers(place - glm::dvec2(origin));
        ++all;
    };
    reading.trees.visit([&](const TreeStore::Trees& trees) {
        for (const TreePlacement& tree : trees)
            take(glm::dvec2(tree.position));
    });
    if (!reading.forest.tiles)
        return {outside, all};
    const TreesInAll trees = reading.treesInAll();
    constexpr int steps = 4;
    for (int i = 0; i < (steps + 1) * (steps + 1); ++i)
        take(glm::mix(glm::dvec2(trees.low), glm::dvec2(trees.high),
                      glm::dvec2(i % (steps + 1), i / (steps + 1)) / double(steps)));
    return {outside, all};
}

/// A note where trees stand beside the points of a file's grid, and a problem where all of them do.
/// @param holds whether the wind of the edge is wanted there.
void checkCover(const WindFile& file, const std::string& path, const glm::dvec3& offset, bool holds,
                TableReader& table, ForestReading& reading) {
    const auto [outside, all] = countOutside(file, reading);
    if (outside == 0)
        return;
    const std::string extent = extentText(file.summary.extent, offset);
    if (outside == all && !holds)
        return table.problem(
            table.has("files") ? "files" : "file",
            "no tree stands where the wind of " + path + " is, " + extent +
                (file.summary.coordinates.empty() ? "" : " of " + file.summary.coordinates) +
                "; expected a wind of the forest's place, or beyond = \"hold\" for that of the edge");
    reading.forest.notes.push_back(
        (reading.forest.tiles ? "parts of the world lie"
                              : std::to_string(outside) + " of " + std::to_string(all) + " trees stand") +
        " outside the grid of " + path + ", " + extent + "; the wind at its edges holds there");
}

/// Wind is wanted where trees stand, and a kilometre around.
void chooseArea(ForestReading& reading, WindFileOptions& options) {
    constexpr double around = 1000.0;
    const TreesInAll trees = reading.treesInAll();
    const glm::dvec3 zero = trees.count > 0 ? reading.forest.origin : glm::dvec3(0.0);
    options.low = glm::dvec2(trees.low - zero) - around;
    options.high = glm::dvec2(trees.high - zero) + around;
}

} // namespace

Wind readWindData(TableReader& table, ForestReading& reading) {
    WindFileOptions options;
    const bool known = readSpeedUnit(table, "speed_unit", options.speedUnit).has_value();
    std::vector<double> numbers = {0, 0, 0};
    table.readNumbers("offset", numbers, 3, 3, worldCoordinates);
    const glm::dvec3 offset(numbers[0], numbers[1], numbers[2]);
    options.origin = reading.forest.origin - offset;
    options.crs = reading.forest.crs;
    table.read("roughness", options.roughness, fieldAt(fieldsOf<LogProfile>(), "roughness").range);
    table.read("height", options.height, fieldAt(fieldsOf<LogProfile>(), "height").range);
    bool holds = false;
    table.readChoice<bool>("beyond", holds, {{"hold", true}});
    chooseArea(reading, options);
    std::vector<std::string> paths;
    std::vector<double> times;
    if (!readDataPaths(table, reading, paths, times) || !known)
        return nullptr;
    Result<WindFile> wind =
        table.has("files") ? readWindFiles(paths, times, options) : readWindFile(paths.front(), options);
    if (!wind) {
        reportWind(wind.problems(), table, reading);
        return nullptr;
    }
    reading.windDate = parseIsoTime(wind.value().summary.start);
    for (const std::string& note : wind.value().summary.notes)
        reading.forest.notes.push_back(paths.front() + ": " + note);
    checkCover(wind.value(), paths.front(), offset, holds, table, reading);
    WindParts::setFiles(wind.value().wind,
                        {paths, table.has("files"), times, offset, reading.forest.origin, options.crs,
                         options.roughness, options.height, options.speedUnit, holds});
    return std::move(wind.value().wind);
}

} // namespace osgTreeWind
