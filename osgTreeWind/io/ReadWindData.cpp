// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ReadWindData.h>

#include <osgTreeWind/base/IsoTime.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/wind/WindInternals.h>
#include <osgTreeWind/windfiles/WindFile.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <glm/common.hpp>

#include <algorithm>

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

void reportWindProblems(const Diagnostics& problems, TableReader& table, ForestReading& reading) {
    for (const Diagnostic& problem : problems) {
        if (problem.file.empty())
            table.problem(table.has(problem.key) ? problem.key : "", problem.message);
        else
            reading.log.add(problem);
    }
}

namespace {

/// Finds the paths of `file`, or of all `files` with their `times`. @return false after a problem.
bool readDataPaths(TableReader& table, ForestReading& reading, std::vector<std::string>& paths,
                   std::vector<double>& times) {
    std::string name;
    std::vector<std::string> names;
    const bool isOne = table.read("file", name), areSeveral = table.read("files", names),
               hasTimes = table.read("times", times);
    const auto fail = [&](const char* key, const char* message) {
        table.problem(key, message);
        return false;
    };
    if (table.has("file") && table.has("files"))
        return fail("files", "give either this or file");
    if (table.has("times") && !table.has("files"))
        return fail("times", "cannot be used without files");
    if (!table.has("file") && !table.has("files"))
        return table.reportMissing("file");
    if (!isOne && !(areSeveral && (hasTimes || !table.has("times"))))
        return false; // the problem is in the log
    for (const std::string& each : isOne ? std::vector<std::string>{name} : names) {
        const auto file = reading.open(table, isOne ? "file" : "files", each);
        if (!file)
            return false;
        paths.push_back(file->path);
    }
    return true;
}

/// "x 385000 to 385700, y 5818000 to 5818500".
std::string extentText(const WindExtent& extent, const glm::dvec2& offset) {
    std::string text;
    for (int axis = 0; axis < 2; ++axis)
        if (!extent.isUnbounded(axis))
            text += std::string(text.empty() ? "" : ", ") + (axis == 0 ? "x " : "y ") +
                    rangeText(extent.low[axis] + offset[axis], extent.high[axis] + offset[axis]);
    return text;
}

/// Counts the trees outside of a wind's grid, and all trees. For a forest in tiles, it samples their bounds.
std::pair<std::size_t, std::size_t> countOutside(const WindFile& file, ForestReading& reading) {
    const glm::dvec3& origin = reading.forest.origin;
    std::size_t outside = 0, all = 0;
    const auto add = [&](const glm::dvec2& place) {
        outside += !file.covers(place - glm::dvec2(origin));
        ++all;
    };
    reading.trees.visit([&](const TreeSpool::Trees& trees) {
        for (const TreePlacement& tree : trees)
            add(glm::dvec2(tree.position));
    });
    if (!reading.forest.tiles)
        return {outside, all};
    const TreeBounds trees = reading.treeBounds();
    constexpr int steps = 4;
    for (int i = 0; i < (steps + 1) * (steps + 1); ++i)
        add(glm::mix(glm::dvec2(trees.low), glm::dvec2(trees.high),
                     glm::dvec2(i % (steps + 1), i / (steps + 1)) / double(steps)));
    return {outside, all};
}

/// Adds a note if some trees are outside of a file's grid, and a problem if all are, unless `allowsOutside`.
void checkCoverage(const WindFile& file, const std::string& path, const glm::dvec3& offset,
                   bool allowsOutside, TableReader& table, ForestReading& reading) {
    const auto [outside, all] = countOutside(file, reading);
    if (outside == 0)
        return;
    const bool onOwnMap = !reading.forest.crs.empty() && !file.summary.crs.empty();
    const std::string extent =
        extentText(file.summary.extent, onOwnMap ? glm::dvec2(0.0) : glm::dvec2(offset)) +
        (file.summary.coordinates.empty() ? "" : " of " + file.summary.coordinates);
    if (outside == all && !allowsOutside) {
        const TreeBounds trees = reading.treeBounds();
        return table.problem(
            table.has("files") ? "files" : "file",
            "no tree is inside the grid of " + path + ", " + extent + "; the trees stand at " +
                extentText({glm::dvec2(trees.low), glm::dvec2(trees.high)}, glm::dvec2(0.0)) +
                (onOwnMap ? " of " + reading.forest.crs : "") +
                "; expected a wind at their place, or beyond = \"hold\" to use that of the edge");
    }
    reading.forest.notes.push_back(
        (reading.forest.tiles ? "parts of the world lie"
                              : std::to_string(outside) + " of " + std::to_string(all) + " trees stand") +
        " outside the grid of " + path + ", " + extent + "; they get the wind at its edge");
}

/// Limits the wind to the bounds of the trees with a margin.
void chooseArea(ForestReading& reading, WindFileOptions& options) {
    constexpr double margin = 1000.0; // metres
    const TreeBounds trees = reading.treeBounds();
    const glm::dvec3 zero = trees.count > 0 ? reading.forest.origin : glm::dvec3(0.0);
    options.low = glm::dvec2(trees.low - zero) - margin;
    options.high = glm::dvec2(trees.high - zero) + margin;
}

} // namespace

Wind readWindData(TableReader& table, ForestReading& reading) {
    WindFileOptions options;
    const bool isUnitKnown = readSpeedUnit(table, "speed_unit", options.speedUnit).has_value();
    std::vector<double> numbers = {0, 0, 0};
    table.readNumbers("offset", numbers, 3, 3, worldCoordinates);
    const glm::dvec3 offset(numbers[0], numbers[1], numbers[2]);
    options.origin = reading.forest.origin - offset;
    options.crs = reading.forest.crs;
    table.read("roughness", options.roughness, fieldAt(fieldsOf<LogProfile>(), "roughness").range);
    table.read("height", options.height, fieldAt(fieldsOf<LogProfile>(), "height").range);
    bool allowsOutside = false;
    table.readChoice<bool>("beyond", allowsOutside, {{"hold", true}});
    chooseArea(reading, options);
    std::vector<std::string> paths;
    std::vector<double> times;
    if (!readDataPaths(table, reading, paths, times) || !isUnitKnown)
        return nullptr;
    Result<WindFile> wind =
        table.has("files") ? readWindFiles(paths, times, options) : readWindFile(paths.front(), options);
    if (!wind) {
        reportWindProblems(wind.problems(), table, reading);
        return nullptr;
    }
    reading.windDate = parseIsoTime(wind.value().summary.start);
    for (const std::string& note : wind.value().summary.notes)
        reading.forest.notes.push_back(paths.front() + ": " + note);
    checkCoverage(wind.value(), paths.front(), offset, allowsOutside, table, reading);
    WindInternals::setFiles(wind.value().wind,
                            {paths, table.has("files"), times, offset, reading.forest.origin, options.crs,
                             options.roughness, options.height, options.speedUnit, allowsOutside});
    return std::move(wind.value().wind);
}

} // namespace osgTreeWind
