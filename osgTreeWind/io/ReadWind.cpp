// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/forest/ForestKeys.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/ReadKeys.h>
#include <osgTreeWind/io/TreeRows.h>
#include <osgTreeWind/places/LongitudeWrap.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindKeys.h>
#include <osgTreeWind/windfiles/WindFile.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <filesystem>

namespace osgTreeWind {

namespace {

constexpr Range directions = within(-360, 360);

/// Reports problems of a wind made from this table: at the key that they name, or else at the table.
void reportWindProblems(const Diagnostics& problems, TableReader& table) {
    for (const Diagnostic& problem : problems) {
        if (problem.file.empty())
            table.problem(table.has(problem.key) ? problem.key : "", problem.message);
        else
            table.report(problem);
    }
}

/// The field made from this table; null if there is none, after reporting the problems.
template <typename Field>
WindFieldPtr checked(const Result<Field>& field, TableReader& table) {
    if (field.ok())
        return field.value();
    reportWindProblems(field.problems(), table);
    return nullptr;
}

/// Reads `velocity`, or `speed` with a direction, in `unit`.
glm::vec3 readVelocity(TableReader& table) {
    const double unit = table.readUnit("unit", Dimension::Speed).value_or(1.0);
    const Range speeds = within(windSpeeds.min / unit, windSpeeds.max / unit);
    glm::vec3 velocity(0.0f);
    WindReading wind;
    const bool hasVelocity = table.read("velocity", velocity, speeds);
    const bool hasSpeed = table.read("speed", wind.speed, within(0.0, speeds.max));
    double degrees = 0.0;
    const bool from = table.read("direction_from", degrees, directions);
    const bool toward = table.read("direction_toward", degrees, directions);
    wind.direction = glm::radians(degrees);
    if (table.has("velocity") == table.has("speed"))
        table.problem("", "expected either velocity, or speed and a direction");
    else if (hasVelocity && (from || toward))
        table.problem(from ? "direction_from" : "direction_toward", "velocity already gives the direction");
    else if (hasSpeed && table.has("direction_from") == table.has("direction_toward"))
        table.problem("speed", "needs either direction_from or direction_toward");
    if (hasSpeed)
        velocity = windVelocity(wind, from ? DirectionSense::From : DirectionSense::Toward);
    return velocity * static_cast<float>(unit);
}

/// Reads `height` and `roughness`, both or neither. @return false after a problem.
bool readProfile(TableReader& table, std::optional<LogProfile>& profile) {
    if (!table.has("height") && !table.has("roughness"))
        return true;
    LogProfile read;
    const Keys& keys = keysOf<LogProfile>();
    bool complete = table.require("height", read.height, keyAt(keys, "height").range);
    complete &= table.require("roughness", read.roughness, keyAt(keys, "roughness").range);
    profile = read;
    if (complete && !read.valid()) {
        table.problem("roughness", "expected less than height");
        return false;
    }
    return complete;
}

Wind readGusts(TableReader& table) {
    const glm::vec3 velocity = readVelocity(table);
    std::optional<LogProfile> profile;
    if (!readProfile(table, profile))
        return nullptr;
    Wind wind(std::make_shared<UniformWind>(velocity, profile));
    wind.gusts.intensity = 0.2;
    return wind;
}

/// Parses finite numbers separated by blanks, line ends, commas or semicolons; '#' starts a comment.
Result<std::vector<double>> readNumberList(std::istream& input, const std::string& file) {
    auto text = readText(input, file);
    if (!text.ok())
        return text.problems();

    const std::string_view all = text.value();
    std::vector<double> numbers;
    std::size_t at = 0;
    while ((at = all.find_first_not_of(" \t\r\n\f,;", at)) != std::string_view::npos) {
        if (all[at] == '#') {
            at = std::min(all.find('\n', at), all.size());
            continue;
        }
        const std::size_t end = std::min(all.find_first_of(" \t\r\n\f,;#", at), all.size());
        const std::string_view word = all.substr(at, end - at);
        const auto number = parseNumber(word);
        if (!number) {
            const TextPosition position = positionInText(all, at);
            return Diagnostic{file, position.line, position.column, "",
                              expectedFound("a finite number", word)};
        }
        numbers.push_back(*number);
        at = end;
    }
    return numbers;
}

/// Reads numbers from the array `values` or the text file `file`.
bool readValues(TableReader& table, const InputFolders& folders, std::vector<float>& values) {
    std::vector<double> numbers;
    if (table.has("values") == table.has("file")) {
        table.problem("", "expected either values or file");
        table.ignoreRest();
        return false;
    }
    if (table.read("values", numbers, windSpeeds)) {
        values.assign(numbers.begin(), numbers.end());
        return true;
    }
    if (table.has("values"))
        return false;
    auto file = folders.open(table, "file");
    if (!file)
        return false;
    const auto list = readNumberList(file->stream, file->path);
    if (!list.ok()) {
        table.report(list.problems().front());
        return false;
    }
    for (double number : list.value())
        if (!windSpeeds.contains(number)) {
            table.problem("file", "expected velocities " + windSpeeds.text() + " m/s");
            return false;
        }
    values.assign(list.value().begin(), list.value().end());
    return true;
}

/// Reads `origin` (world) or `corner` (relative to the forest's origin). @return false after a problem.
bool readCorner(TableReader& table, const SceneMap& map, const glm::dvec3& zero, glm::dvec3& corner) {
    std::vector<double> from = {0, 0, 0}, world = {zero.x, zero.y, zero.z};
    const bool hasCorner = table.readNumbers("corner", from, 3, 3, worldCoordinates),
               hasOrigin = table.readNumbers("origin", world, 3, 3, worldCoordinates);
    corner = hasCorner   ? glm::dvec3(from[0], from[1], from[2])
             : hasOrigin ? map.toScene({world[0], world[1], world[2]}) - zero
                         : glm::dvec3(0.0);
    if (table.has("corner") && table.has("origin"))
        table.problem("corner", "give either this or origin");
    return hasCorner == table.has("corner") && hasOrigin == table.has("origin") && !(hasCorner && hasOrigin);
}

Wind readGrid(TableReader& table, const InputFolders& folders, const SceneMap& map,
              const glm::dvec3& origin) {
    GridWind::Grid grid;
    std::vector<double> points, cell;
    bool complete = table.readNumbers("points", points, 2, 3, gridPoints) || table.reportMissing("points");
    complete &= table.readNumbers("cell", cell, 2, 3, gridCells) || table.reportMissing("cell");
    complete &= readCorner(table, map, origin, grid.origin);
    complete &= table.read("times", grid.times) || !table.has("times");
    std::vector<double> heights;
    complete &= table.read("heights", heights) || !table.has("heights");
    grid.heights.assign(heights.begin(), heights.end());
    complete &= table.read("roughness", grid.roughness, keyAt(keysOf<GridWind::Grid>(), "roughness").range) ||
                !table.has("roughness");
    complete &= table.read("above_ground", grid.aboveGround) || !table.has("above_ground");
    complete &= readValues(table, folders, grid.values);
    std::vector<double> deviations;
    complete &= table.read("deviations", deviations, keyAt(keysOf<GridWind::Grid>(), "deviations").range) ||
                !table.has("deviations");
    grid.deviations.assign(deviations.begin(), deviations.end());
    if (!complete)
        return nullptr;
    for (std::size_t i = 0; i < points.size(); ++i) {
        grid.points[static_cast<int>(i)] = static_cast<int>(points[i]);
        if (grid.points[static_cast<int>(i)] != points[i])
            table.problem("points", "expected whole numbers");
    }
    for (std::size_t i = 0; i < cell.size(); ++i)
        grid.cell[static_cast<int>(i)] = cell[i];
    if (points.size() == 3 && cell.size() == 2)
        table.problem("cell", "expected 3 numbers, as in points");
    return checked(GridWind::create(std::move(grid)), table);
}

Wind readForestWind(TableReader& table, const InputFolders& folders, const SceneMap& map,
                    const glm::dvec3& origin) {
    int width = 0, length = 0;
    glm::dvec3 corner(0.0);
    std::vector<float> values;
    bool complete = table.require("width", width, gridPoints);
    complete &= table.require("length", length, gridPoints);
    complete &= readCorner(table, map, origin, corner);
    complete &= readValues(table, folders, values);
    if (!complete)
        return nullptr;
    return checked(GridWind::fromForestWind(width, length, std::move(values), corner), table);
}

/// Reads one name or an array of names.
bool readNames(TableReader& table, const char* key, std::vector<std::string>& names) {
    std::string name;
    if (table.hasArray(key))
        return table.read(key, names);
    if (!table.read(key, name))
        return false;
    names = {name};
    return true;
}

/// Reads `speed_unit`. @return false after a problem.
bool readSpeedUnit(TableReader& table, std::string& name) {
    return table.readUnit("speed_unit", Dimension::Speed, &name) || !table.has("speed_unit");
}

/// Reads the columns of a CSV record.
bool readSeriesColumns(TableReader& table, WindSeriesColumns& columns) {
    const TableOptions options = readTableOptions(table);
    columns.delimiter = options.delimiter;
    columns.decimalComma = options.decimalComma;
    columns.headerLine = options.headerLine;
    columns.comment = options.comment;
    table.read("missing", columns.missing);
    if (table.hasText("time_unit", "iso8601"))
        table.read("time_unit", columns.timeUnit);
    else
        table.readUnit("time_unit", Dimension::Time, &columns.timeUnit);
    table.readChoice<std::string>("time_order", columns.timeOrder, {{"dmy", "dmy"}, {"mdy", "mdy"}});
    table.read("time_format", columns.timeFormat);
    table.readUnit("direction_unit", Dimension::Direction, &columns.directionUnit);
    const bool isUnitKnown = readSpeedUnit(table, columns.speedUnit);
    if (!table.has("columns"))
        return table.reportMissing("columns");
    table.table("columns", [&](TableReader& t) {
        if (!readNames(t, "time", columns.time))
            t.reportMissing("time");
        t.read("u", columns.u);
        t.read("v", columns.v);
        t.read("w", columns.w);
        t.read("speed", columns.speed);
        const bool from = t.read("direction_from", columns.direction);
        const bool toward = t.read("direction_toward", columns.direction);
        if (from && toward)
            t.problem("direction_toward", "give either this or direction_from");
        columns.sense = toward ? DirectionSense::Toward : DirectionSense::From;
    });
    return isUnitKnown;
}

/// Reads a record from a file. A table needs `columns`; QES sensor XML and EPW do not.
bool readSeriesFile(TableReader& table, const InputFolders& folders, WindSeries& series) {
    auto file = folders.open(table, "file");
    std::string name;
    table.read("file", name);
    const std::string extension = lower(extensionOf(name));
    WindSeriesColumns columns;
    const bool needsColumns = extension != ".xml" && (extension != ".epw" || table.has("columns"));
    if (needsColumns && !readSeriesColumns(table, columns))
        return false;
    if (!file)
        return false;
    std::vector<std::string> notes;
    auto record = readWindSeries(file->path, columns, &notes);
    for (const std::string& note : notes)
        table.note(file->path + ": " + note);
    if (record.ok()) {
        series = std::move(record.value());
        return true;
    }
    for (const Diagnostic& problem : record.problems())
        if (problem.line > 0)
            table.report(problem);
        else
            table.problem("", problem.text());
    return false;
}

/// Reads a record from the document: `times` and `velocities`.
bool readSeriesValues(TableReader& table, WindSeries& series) {
    std::vector<std::vector<double>> velocities;
    bool complete = table.require("times", series.times);
    if (!table.readRows("velocities", velocities, 3, windSpeeds))
        complete = table.reportMissing("velocities");
    for (const std::vector<double>& v : velocities)
        series.velocities.emplace_back(v[0], v[1], v[2]);
    return complete;
}

/// @param date gets that of the time 0, if the file states it.
Wind readSeries(TableReader& table, const InputFolders& folders, std::optional<double>& date) {
    WindSeries series;
    bool complete =
        table.has("file") ? readSeriesFile(table, folders, series) : readSeriesValues(table, series);
    table.read("repeat", series.repeat);
    complete &= readProfile(table, series.profile);
    date = series.date;
    Wind wind = complete ? checked(TimeSeriesWind::create(std::move(series)), table) : nullptr;
    if (wind.field && date) {
        WindFiles known;
        known.date = date;
        setKnown(wind, std::move(known));
    }
    return wind;
}

/// Finds the paths of `file`, or of all `files` with their `times`. @return false after a problem.
bool readDataPaths(TableReader& table, const InputFolders& folders, std::vector<std::string>& paths,
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
        const auto file = folders.open(table, isOne ? "file" : "files", each);
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
std::pair<std::size_t, std::size_t> countOutside(const WindFile& file, const ForestDescription& forest,
                                                 DocumentTrees& trees) {
    const glm::dvec3& origin = forest.origin;
    std::size_t outside = 0, all = 0;
    const auto add = [&](const glm::dvec2& place) {
        outside += !file.covers(place - glm::dvec2(origin));
        ++all;
    };
    trees.visit([&](const TreeSpool::Trees& some) {
        for (const TreePlacement& tree : some)
            add(glm::dvec2(tree.position));
    });
    if (!forest.tiles)
        return {outside, all};
    const TreeBounds& bounds = trees.bounds();
    constexpr int steps = 4;
    for (int i = 0; i < (steps + 1) * (steps + 1); ++i)
        add(glm::mix(glm::dvec2(bounds.low), glm::dvec2(bounds.high),
                     glm::dvec2(i % (steps + 1), i / (steps + 1)) / double(steps)));
    return {outside, all};
}

/// Whether a place is inside a wind's grid, also far from the trees, where WindFile::covers() is inexact.
bool isInGrid(const WindFile& file, const ForestDescription& forest, glm::dvec2 place) {
    const auto from = Crs::parse(forest.crs), to = Crs::parse(file.summary.crs);
    const auto transform = from && to ? CrsTransform::between(from.value(), to.value()) : Diagnostics();
    const WindExtent& extent = file.summary.extent;
    if (!transform || !transform.value().apply(place))
        return false;
    if (to.value().isDegrees() && !extent.isUnbounded(0))
        place.x += longitudeWrap(place.x, 0.5 * (extent.low.x + extent.high.x));
    return extent.contains(place);
}

/// Adds a note if some trees are outside of a file's grid, and a problem if all are, unless `allowsOutside`.
void checkCoverage(const WindFile& file, const std::string& path, const glm::dvec3& offset,
                   bool allowsOutside, TableReader& table, const ForestDescription& forest,
                   DocumentTrees& trees) {
    const auto [outside, all] = countOutside(file, forest, trees);
    if (outside == 0)
        return;
    const bool onOwnMap = !forest.crs.empty() && !file.summary.crs.empty();
    const std::string extent =
        extentText(file.summary.extent, onOwnMap ? glm::dvec2(0.0) : glm::dvec2(offset)) +
        (file.summary.coordinates.empty() ? "" : " of " + file.summary.coordinates);
    if (outside == all && !allowsOutside) {
        const TreeBounds& bounds = trees.bounds();
        return table.problem(
            table.has("files") ? "files" : "file",
            "no tree is inside the grid of " + path + ", " + extent + "; the trees stand at " +
                extentText({glm::dvec2(bounds.low), glm::dvec2(bounds.high)}, glm::dvec2(0.0)) +
                (onOwnMap ? " of " + forest.crs : "") +
                "; expected a wind at their place, or beyond = \"hold\" to use that of the edge" +
                trees.adviceToExchange([&](const glm::dvec2& place) {
                    return onOwnMap ? isInGrid(file, forest, place)
                                    : file.covers(place - glm::dvec2(forest.origin));
                }));
    }
    table.note((forest.tiles ? "parts of the world lie"
                             : std::to_string(outside) + " of " + std::to_string(all) + " trees stand") +
               " outside the grid of " + path + ", " + extent + "; they get the wind at its edge");
}

/// Limits the wind to the bounds of the trees with a margin.
void chooseArea(const glm::dvec3& origin, DocumentTrees& trees, WindFileOptions& options) {
    constexpr double margin = 1000.0; // metres
    const TreeBounds& bounds = trees.bounds();
    const glm::dvec3 zero = bounds.count > 0 ? origin : glm::dvec3(0.0);
    options.low = glm::dvec2(bounds.low - zero) - margin;
    options.high = glm::dvec2(bounds.high - zero) + margin;
}

/// Reads files of wind data, in world coordinates moved by `offset`. Null after a problem.
/// @param date gets that of the time 0, seconds since 1970, if the files state it.
Wind readWindData(TableReader& table, const InputFolders& folders, const ForestDescription& forest,
                  DocumentTrees& trees, std::optional<double>& date) {
    WindFileOptions options;
    const bool isUnitKnown = readSpeedUnit(table, options.speedUnit);
    if (options.speedUnit == "m/s") // which version 1.0 wrote for files of any unit
        options.speedUnit.clear();
    std::vector<double> numbers = {0, 0, 0};
    table.readNumbers("offset", numbers, 3, 3, worldCoordinates);
    const glm::dvec3 offset(numbers[0], numbers[1], numbers[2]);
    options.origin = forest.origin - offset;
    options.crs = forest.crs;
    table.read("roughness", options.roughness, keyAt(keysOf<LogProfile>(), "roughness").range);
    table.read("height", options.height, keyAt(keysOf<LogProfile>(), "height").range);
    readNames(table, "variable", options.variable);
    bool allowsOutside = false;
    table.readChoice<bool>("beyond", allowsOutside, {{"hold", true}});
    chooseArea(forest.origin, trees, options);
    std::vector<std::string> paths;
    std::vector<double> times;
    if (!readDataPaths(table, folders, paths, times) || !isUnitKnown)
        return nullptr;
    Result<WindFile> wind =
        table.has("files") ? readWindFiles(paths, times, options) : readWindFile(paths.front(), options);
    if (!wind) {
        reportWindProblems(wind.problems(), table);
        return nullptr;
    }
    date = parseDate(wind.value().summary.start);
    for (const std::string& note : wind.value().summary.notes)
        table.note(paths.front() + ": " + note);
    checkCoverage(wind.value(), paths.front(), offset, allowsOutside, table, forest, trees);
    Wind& read = wind.value().wind;
    WindFiles known = knownOf(read) ? *knownOf(read) : WindFiles();
    known.files = paths;
    known.series = table.has("files");
    known.times = times;
    known.offset = offset;
    known.origin = forest.origin;
    known.crs = options.crs;
    known.roughness = options.roughness;
    known.height = options.height;
    known.speedUnit = options.speedUnit;
    known.variable = options.variable;
    known.mayIncludeTrees = wind.value().summary.mayIncludeTrees;
    if (date && read.clock.scale == 1.0)
        known.date = *date - read.clock.start;
    known.allowsOutside = allowsOutside;
    setKnown(read, std::move(known));
    return std::move(read);
}

/// Sets the clock's start from `date`, the date of the wind at time 0, which replaces `start`.
/// @param windDate as for readWindData().
void setStartDate(const std::string& text, TableReader& table, const std::optional<double>& windDate,
                  WindClock& clock) {
    const std::optional<double> date = parseDate(text);
    if (table.has("start"))
        table.problem("date", "give either this or start");
    else if (!date)
        table.problem("date", expectedFound("a date and time, as 2017-10-26T15:00:00Z", text));
    else if (!windDate)
        table.problem("date", "expected a wind from files whose times are dates");
    else
        clock.start = *date - *windDate;
}

/// Reads `travel`, the velocity with which the wind passes over the forest, or "mean" for that of a record.
void readTravel(TableReader& table, const Wind& wind, WindClock& clock) {
    std::string word;
    std::vector<double> numbers;
    if (table.hasArray("travel") ? !table.readNumbers("travel", numbers, 2, 2, windSpeeds)
                                 : !table.readScalar("travel", word))
        return;
    const auto* record = dynamic_cast<const TimeSeriesWind*>(wind.field.get());
    glm::dvec2 travel(0.0);
    if (!numbers.empty())
        travel = {numbers[0], numbers[1]};
    else if (word != "mean")
        return table.problem("travel", expectedFound("\"mean\" or [u, v] in m/s", word));
    else if (record)
        travel = glm::dvec2(meanVelocity(record->series()));
    else
        return table.problem("travel", "\"mean\" needs a record at one point; expected [u, v] in m/s");
    if (wind.clock.travels())
        table.problem("travel", "this wind already travels");
    else if (const double speed = glm::length(travel); !(speed >= 0.1))
        table.problem("travel", "expected 0.1 m/s or more, found " + numberText(speed));
    else
        clock.travel = travel;
}

/// Reads one [[wind.source]].
WindSource readSource(TableReader& table, const SceneMap& map, const glm::dvec3& origin) {
    WindSource source;
    readKeys(table, source);
    const auto readVector = [&](const char* key, glm::dvec3& vector) {
        std::vector<double> numbers;
        const Range& range =
            keyAt(keysOf<WindSource>(), key == std::string("velocity") ? key : "place").range;
        if (table.readNumbers(key, numbers, 3, 3, range))
            vector = glm::dvec3(numbers[0], numbers[1], numbers[2]);
    };
    readVector("velocity", source.velocity);
    readVector("place", source.position);
    readVector("position", source.position);
    if (table.has("position"))
        source.position = map.toScene(source.position) - origin;
    if (!table.has("kind"))
        table.reportMissing("kind");
    if (table.has("position") && table.has("place"))
        table.problem("place", "give either this or position");
    else if (!table.has("position") && !table.has("place"))
        table.reportMissing("position");
    return source;
}

} // namespace

const std::vector<std::pair<std::string, WindFrame>>& windFrames() {
    static const std::vector<std::pair<std::string, WindFrame>> frames = {
        {"forest", WindFrame::Forest}, {"scene", WindFrame::Scene}, {"geocentric", WindFrame::Geocentric}};
    return frames;
}

Wind readWind(TableReader& table, const InputFolders& folders, const ForestDescription& forest,
              const SceneMap& map, DocumentTrees& trees, std::uint32_t seed) {
    const glm::dvec3& origin = forest.origin;
    std::optional<double> windDate;
    using Read = std::function<Wind()>;
    const Read readData = [&] { return readWindData(table, folders, forest, trees, windDate); };
    Read read;
    table.readChoice<Read>(
        "kind", read,
        {{"calm", [] { return Wind(nullptr); }},
         {"uniform", [&] { return Wind(std::make_shared<UniformWind>(readVelocity(table))); }},
         {"gusts", [&] { return readGusts(table); }},
         {"grid", [&] { return readGrid(table, folders, map, origin); }},
         {"forest_wind", [&] { return readForestWind(table, folders, map, origin); }},
         {"series", [&] { return readSeries(table, folders, windDate); }},
         {"file", readData}});
    const bool isOtherKind = table.has("kind") || table.has("columns") || table.has("points");
    if (!isOtherKind && (table.has("file") || table.has("files")))
        read = readData;
    if (!read) {
        table.reportMissing("kind");
        table.ignoreRest();
        return nullptr;
    }
    Wind wind = read();
    if (!table.hasText("kind", "calm")) {
        readKeys(table, wind.gusts);
        if (wind.gusts.intensity > 0.0 && !table.has("seed"))
            wind.gusts.seed = seed;
        if (wind.gusts.intensity > 0.0 && wind.field && wind.field->turbulence())
            table.note(
                "gusts have the strength of the turbulence in the wind data, not that of wind.intensity");
    }
    WindClock clock;
    readKeys(table, clock);
    std::string date;
    if (table.readScalar("date", date) && (wind.field || table.hasText("kind", "calm")))
        setStartDate(date, table, windDate, clock);
    readTravel(table, wind, clock);
    wind.clock = clock.then(wind.clock);
    readKeys(table, wind.adjustment);
    wind.frame = WindFrame::Forest;
    table.readChoice("frame", wind.frame, windFrames());
    table.tables("source",
                 [&](TableReader& source) { wind.sources.push_back(readSource(source, map, origin)); });
    return wind;
}

} // namespace osgTreeWind
