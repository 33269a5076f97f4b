// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindFile.h>

#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/TravellingWind.h>
#include <osgTreeWind/wind/WindFormats.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/wind/WindSteps.h>
#include <osgTreeWind/wind/WindUnits.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace osgTreeWind {

namespace {

Diagnostic problem(const std::string& file, std::string message) {
    return {file, 0, 0, {}, std::move(message)};
}

/// Converts one velocity to m/s and takes note of it. False when no wind is like this.
bool takeIn(glm::vec3& velocity, float unit, WindSummary& summary, std::size_t& missing) {
    const bool known = !std::isnan(velocity.x) && !std::isnan(velocity.y) && !std::isnan(velocity.z);
    if (!known)
        ++missing;
    velocity = known ? velocity * unit : glm::vec3(0.0f);
    const double speed = glm::length(glm::dvec3(velocity));
    if (!(speed <= maxMeasuredSpeed))
        return false;
    if (known) {
        summary.slowest = std::min(summary.slowest, speed);
        summary.fastest = std::max(summary.fastest, speed);
    }
    return true;
}

/// Settles the unit, the range of speeds and places without data.
/// @param files each gave the same number of velocities, one after the other.
Diagnostics settle(WindContent& content, double unit, const std::vector<std::string>& files) {
    auto* series = std::get_if<WindSeries>(&content.data);
    auto* grid = std::get_if<GridWind::Grid>(&content.data);
    const std::size_t count = series ? series->velocities.size() : grid->values.size() / 3;
    const std::size_t perFile = std::max<std::size_t>(1, count / files.size());
    const std::string ofAll = " of " + std::to_string(perFile);
    WindSummary& summary = content.summary;
    summary.slowest = std::numeric_limits<double>::max();
    std::vector<std::size_t> missing(files.size(), 0);
    for (std::size_t i = 0; i < count; ++i) {
        float* values = series ? &series->velocities[i].x : &grid->values[3 * i];
        glm::vec3 velocity(values[0], values[1], values[2]);
        if (!takeIn(velocity, static_cast<float>(unit), summary, missing[i / perFile]))
            return {problem(files[i / perFile], "expected winds of at most 200 m/s; number " +
                                                    std::to_string(i % perFile + 1) + ofAll + " is none")};
        std::copy(&velocity.x, &velocity.x + 3, values);
    }
    for (std::size_t file = 0; file < files.size(); ++file)
        if (missing[file] == perFile || count == 0)
            return {problem(files[file], "holds no data at any" + ofAll + " places and times")};
    if (const std::size_t all = std::accumulate(missing.begin(), missing.end(), std::size_t(0)); all > 0)
        summary.notes.push_back(std::to_string(all) + " of " + std::to_string(count) +
                                " velocities have no data and are taken as calm");
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

template <typename Field>
Result<WindFieldPtr> named(const Result<Field>& field, const std::string& path) {
    if (field)
        return WindFieldPtr(field.value());
    Diagnostics problems = field.problems();
    for (Diagnostic& one : problems)
        one.file = path;
    return problems;
}

Result<WindFieldPtr> fieldOf(WindContent&& content, const glm::dvec3& origin, const std::string& path) {
    if (auto* series = std::get_if<WindSeries>(&content.data))
        return named(TimeSeriesWind::create(std::move(*series)), path);
    auto& grid = std::get<GridWind::Grid>(content.data);
    grid.origin -= origin;
    for (float& height : grid.heights)
        height -= static_cast<float>(origin.z);
    Result<WindFieldPtr> field = named(GridWind::create(std::move(grid)), path);
    if (field && content.travelSpeed > 0.0)
        return WindFieldPtr(std::make_shared<TravellingWind>(field.value(), -origin.x, content.travelSpeed));
    return field;
}

/// What was read from these files as a field.
Result<WindFile> fileOf(Result<WindContent>&& read, const std::vector<std::string>& files,
                        const WindFileOptions& options) {
    if (!read)
        return read.problems();
    WindContent& content = read.value();
    const std::string& unitName = content.summary.unit.empty() ? options.speedUnit : content.summary.unit;
    const Result<double> unit = speedUnit(unitName);
    if (!unit)
        return problem(files.front(), unit.problems().front().message);
    Diagnostics problems = settle(content, unit.value(), files);
    if (!problems.empty())
        return problems;

    WindFile file;
    if (content.summary.unit.empty())
        content.summary.notes.push_back("the file names no unit of speed; taken as " + unitName);
    if (const auto* grid = std::get_if<GridWind::Grid>(&content.data))
        summarize(*grid, content.summary);
    else
        content.summary.times = std::get<WindSeries>(content.data).times;
    file.summary = std::move(content.summary);
    Result<WindFieldPtr> field = fieldOf(std::move(content), options.origin, files.front());
    if (!field)
        return field.problems();
    file.field = field.value();
    return file;
}

/// A problem with the options, if there is one.
Diagnostics check(const WindFileOptions& options) {
    const Result<double> unit = speedUnit(options.speedUnit);
    return unit ? Diagnostics() : Diagnostics{{{}, 0, 0, "speedUnit", unit.problems().front().message}};
}

} // namespace

Result<WindFile> readWindFile(const std::string& path, const WindFileOptions& options) {
    if (Diagnostics problems = check(options); !problems.empty())
        return problems;
    return fileOf(readWindContent(path, options.columns), {path}, options);
}

Result<WindFile> readWindFiles(const std::vector<std::string>& files, const std::vector<double>& times,
                               const WindFileOptions& options) {
    if (Diagnostics problems = check(options); !problems.empty())
        return problems;
    return fileOf(readWindSteps(files, times, options.columns), files, options);
}

Result<WindFieldPtr> readWindField(const std::string& path, const WindFileOptions& options) {
    Result<WindFile> file = readWindFile(path, options);
    if (!file)
        return file.problems();
    return file.value().field;
}

} // namespace osgTreeWind
