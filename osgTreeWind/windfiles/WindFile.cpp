// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFile.h>

#include <osgTreeWind/base/Problem.h>

#include <osgTreeWind/wind/RetimedWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindSteps.h>
#include <osgTreeWind/windfiles/WindUnits.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace osgTreeWind {

namespace {

/// Converts one velocity to m/s and takes note of it. False when no wind is like this.
bool takeIn(glm::vec3& velocity, float unit, WindContent& content) {
    const bool known = !std::isnan(velocity.x) && !std::isnan(velocity.y) && !std::isnan(velocity.z);
    if (!known)
        ++content.missing;
    velocity = known ? velocity * unit : glm::vec3(0.0f);
    const double speed = glm::length(glm::dvec3(velocity));
    if (!(speed <= maxMeasuredSpeed))
        return false;
    if (known) {
        content.summary.slowest = std::min(content.summary.slowest, speed);
        content.summary.fastest = std::max(content.summary.fastest, speed);
    }
    return true;
}

std::size_t velocityCount(const WindContent& content) {
    const auto* series = std::get_if<WindSeries>(&content.data);
    return series ? series->velocities.size() : std::get<GridWind::Grid>(content.data).values.size() / 3;
}

/// Settles the unit, the range of speeds and places without data.
Diagnostics settle(WindContent& content, double unit, const std::string& path) {
    auto* series = std::get_if<WindSeries>(&content.data);
    auto* grid = std::get_if<GridWind::Grid>(&content.data);
    const std::size_t count = velocityCount(content);
    const std::string ofAll = " of " + std::to_string(count);
    content.summary.slowest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
        float* values = series ? &series->velocities[i].x : &grid->values[3 * i];
        glm::vec3 velocity(values[0], values[1], values[2]);
        if (!takeIn(velocity, static_cast<float>(unit), content))
            return {fileProblem(path, "expected winds of at most 200 m/s; number " + std::to_string(i + 1) +
                                          ofAll + " is none")};
        std::copy(&velocity.x, &velocity.x + 3, values);
    }
    if (content.missing == count)
        return {fileProblem(path, "holds no data at any" + ofAll + " places and times")};
    return {};
}

void summarize(const GridWind::Grid& grid, WindSummary& summary) {
    summary.points = grid.points;
    summary.low = grid.origin;
    summary.high = grid.origin + grid.cell * glm::dvec3(grid.points - 1);
    summary.times = grid.times;
    if (!grid.heights.empty()) {
        const auto [low, high] = std::minmax_element(grid.heights.begin(), grid.heights.end());
        summary.low.z = *low;
        summary.high.z = *high;
    }
}

Diagnostics named(Diagnostics problems, const std::string& path) {
    for (Diagnostic& one : problems)
        one.file = path;
    return problems;
}

template <typename Field>
Result<WindFieldPtr> named(const Result<Field>& field, const std::string& path) {
    if (field)
        return WindFieldPtr(field.value());
    return named(field.problems(), path);
}

Result<WindFieldPtr> fieldOf(WindContent&& content, const glm::dvec3& origin, const std::string& path) {
    if (auto* series = std::get_if<WindSeries>(&content.data))
        return named(TimeSeriesWind::create(std::move(*series)), path);
    auto& grid = std::get<GridWind::Grid>(content.data);
    grid.origin -= origin;
    for (float& height : grid.heights)
        height -= static_cast<float>(origin.z);
    Result<WindFieldPtr> field = named(GridWind::create(std::move(grid)), path);
    if (!field || !(content.travelSpeed > 0.0))
        return field;
    RetimedWind::Clock clock;
    clock.plane = -origin.x;
    clock.speed = content.travelSpeed;
    return WindFieldPtr(std::make_shared<RetimedWind>(field.value(), clock));
}

/// One file, velocities in m/s.
Result<WindContent> readSettled(const std::string& path, const WindFileOptions& options) {
    WindRequest request{options.columns, options.asStored, {}};
    request.columns.speedUnit = "m/s"; // converted with all other formats
    Result<WindContent> read = readWindContent(path, request);
    if (!read)
        return read;
    const std::string& inFile = read.value().summary.unit;
    const Result<double> unit = speedUnit(inFile.empty() ? options.speedUnit : inFile);
    if (!unit)
        return fileProblem(path, unit.problems().front().message);
    if (Diagnostics problems = settle(read.value(), unit.value(), path); !problems.empty())
        return problems;
    return read;
}

/// What was read as a field. @param path of the first file.
Result<WindFile> fileOf(Result<WindContent>&& read, const std::string& path, const WindFileOptions& options) {
    if (!read)
        return read.problems();
    WindContent& content = read.value();
    std::vector<std::string>& notes = content.summary.notes;
    if (content.missing > 0)
        notes.push_back(std::to_string(content.missing) + " of " + std::to_string(velocityCount(content)) +
                        " velocities have no data and are taken as calm");
    if (content.summary.unit.empty())
        notes.push_back("the file names no unit of speed; taken as " + options.speedUnit);
    if (const auto* grid = std::get_if<GridWind::Grid>(&content.data))
        summarize(*grid, content.summary);
    else
        content.summary.times = std::get<WindSeries>(content.data).times;
    WindFile file;
    file.summary = std::move(content.summary);
    Result<WindFieldPtr> field = fieldOf(std::move(content), options.origin, path);
    if (!field)
        return field.problems();
    file.field = field.value();
    return file;
}

/// A problem with the options, if there is one.
Diagnostics check(const WindFileOptions& options) {
    const Result<double> unit = speedUnit(options.speedUnit);
    return unit ? Diagnostics() : Diagnostics{keyProblem("speedUnit", unit.problems().front().message)};
}

} // namespace

Result<WindFile> readWindFile(const std::string& path, const WindFileOptions& options) {
    if (Diagnostics problems = check(options); !problems.empty())
        return problems;
    return fileOf(readSettled(path, options), path, options);
}

Result<WindFile> readWindFiles(const std::vector<std::string>& files, const std::vector<double>& times,
                               const WindFileOptions& options) {
    if (Diagnostics problems = check(options); !problems.empty())
        return problems;
    const auto read = [&](const std::string& file) {
        Result<WindContent> step = readSettled(file, options);
        if (const auto* grid = step ? std::get_if<GridWind::Grid>(&step.value().data) : nullptr)
            if (Diagnostics problems = named(GridWind::check(*grid), file); !problems.empty())
                return Result<WindContent>(problems); // of this file, before they are joined
        return step;
    };
    return fileOf(readWindSteps(files, times, read), files.empty() ? "" : files.front(), options);
}

Result<WindSeries> readWindSeries(const std::string& path, const WindSeriesColumns& columns) {
    Result<WindContent> read = readWindContent(path, {columns, false, {}});
    if (!read)
        return read.problems();
    auto* series = std::get_if<WindSeries>(&read.value().data);
    if (!series)
        return fileProblem(path,
                           "expected a record at one point, found a grid: " + read.value().summary.format);
    const std::string& inFile = read.value().summary.unit;
    const Result<double> unit = speedUnit(inFile.empty() ? "m/s" : inFile);
    if (!unit)
        return fileProblem(path, unit.problems().front().message);
    for (glm::vec3& velocity : series->velocities)
        velocity *= static_cast<float>(unit.value());
    return std::move(*series);
}

Result<WindFieldPtr> readWindField(const std::string& path, const WindFileOptions& options) {
    Result<WindFile> file = readWindFile(path, options);
    if (!file)
        return file.problems();
    return file.value().field;
}

} // namespace osgTreeWind
