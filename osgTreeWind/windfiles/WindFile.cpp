// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindFile.h>

#include <osgTreeWind/base/CsvTable.h>
#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/base/Unicode.h>

#include <osgTreeWind/places/CrsMesh.h>
#include <osgTreeWind/places/LongitudeWrap.h>
#include <osgTreeWind/places/MapProgram.h>
#include <osgTreeWind/places/UnitSize.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindLimits.h>
#include <osgTreeWind/windfiles/WindFormats.h>
#include <osgTreeWind/windfiles/WindSteps.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace osgTreeWind {

namespace {

/// Whether a component is a number and not a code for a missing value, such as -9999.
bool isKnown(float component) {
    constexpr float smallestCode = 99.0f;
    return !std::isnan(component) &&
           (std::abs(component) < smallestCode || !isMissing(static_cast<double>(component)));
}

/// Converts a velocity to m/s and updates the summary; missing becomes 0. @return false if too fast.
bool convertVelocity(glm::vec3& velocity, float unit, WindContent& content) {
    const bool known = isKnown(velocity.x) && isKnown(velocity.y) && isKnown(velocity.z);
    if (!known)
        ++content.missingCount;
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

/// Converts all velocities to m/s; sets the range of speeds and the number of missing velocities.
/// @param asked replaces the unit of the file unless empty.
Diagnostics convertVelocities(WindContent& content, const std::string& asked, const std::string& path) {
    const std::string& inFile = content.summary.unit;
    const Result<double> unit = asked.empty() && inFile.empty()
                                    ? Result<double>(1.0)
                                    : sizeOfUnit(Dimension::Speed, asked.empty() ? inFile : asked);
    if (!unit)
        return {fileProblem(path, unit.problems().front().message + "; speed_unit replaces it")};
    if (asked.empty() && inFile.empty())
        content.assumptions.push_back("the file gives no unit of speed; m/s is assumed");
    if (!asked.empty() && !inFile.empty() && knownUnit(Dimension::Speed, inFile) != unit.value())
        content.assumptions.push_back("speed_unit, " + asked + ", replaces the unit of the file, " + inFile);
    auto* series = std::get_if<WindSeries>(&content.data);
    auto* grid = std::get_if<GridWind::Grid>(&content.data);
    const std::size_t count = velocityCount(content);
    const std::string ofAll = " of " + std::to_string(count);
    content.summary.slowest = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < count; ++i) {
        float* values = series ? &series->velocities[i].x : &grid->values[3 * i];
        glm::vec3 velocity(values[0], values[1], values[2]);
        if (!convertVelocity(velocity, static_cast<float>(unit.value()), content))
            return {fileProblem(path, "expected winds of at most 200 m/s; number " + std::to_string(i + 1) +
                                          ofAll + " is faster")};
        std::copy(&velocity.x, &velocity.x + 3, values);
    }
    if (grid)
        for (float& deviation : grid->deviations)
            if (!((deviation *= static_cast<float>(unit.value())) <= static_cast<float>(maxMeasuredSpeed)))
                return {fileProblem(path, "expected turbulence of at most 200 m/s, found " +
                                              numberText(static_cast<double>(deviation)))};
    if (content.missingCount == count)
        return {fileProblem(path, "has no data at any" + ofAll + " places and times")};
    return {};
}

void noteMissing(const WindContent& content, std::vector<std::string>& notes) {
    if (content.missingCount > 0)
        notes.push_back(std::to_string(content.missingCount) + " of " +
                        std::to_string(velocityCount(content)) +
                        " velocities have no data and are taken as calm");
}

void summarize(const GridWind::Grid& grid, WindSummary& summary) {
    summary.points = grid.points;
    summary.aboveGround = grid.aboveGround;
    summary.low = grid.origin;
    summary.high = grid.origin + grid.cell * glm::dvec3(grid.points - 1);
    summary.times = grid.times;
    if (!grid.heights.empty()) {
        const auto [low, high] = std::minmax_element(grid.heights.begin(), grid.heights.end());
        summary.low.z = *low;
        summary.high.z = *high;
    }
}

Diagnostics withPath(Diagnostics problems, const std::string& path) {
    for (Diagnostic& one : problems)
        one.file = path;
    return problems;
}

template <typename Field>
Result<WindFieldPtr> withPath(const Result<Field>& field, const std::string& path) {
    if (field)
        return WindFieldPtr(field.value());
    return withPath(field.problems(), path);
}

WindExtent extentOf(const WindSummary& summary) {
    WindExtent extent;
    for (int axis = 0; axis < 2; ++axis)
        if (summary.points[axis] > 1) {
            extent.low[axis] = summary.low[axis];
            extent.high[axis] = summary.high[axis];
        }
    return extent;
}

/// Makes grid coordinates relative to the scene's origin. @param there the origin on the grid's map.
void moveOrigin(const glm::dvec2& there, double height, GridWind::Grid& grid) {
    grid.origin -= glm::dvec3(there, 0.0);
    if (grid.aboveGround)
        return;
    grid.origin.z -= height;
    for (float& each : grid.heights)
        each -= static_cast<float>(height);
}

/// Transform from the scene's CRS to the file's; null if they are the same or one is unknown.
Result<std::shared_ptr<const CrsMesh>> meshToFile(const std::string& fileCrs,
                                                  const WindFileOptions& options) {
    if (fileCrs.empty() || options.crs.empty())
        return std::shared_ptr<const CrsMesh>();
    const Result<Crs> here = Crs::parse(options.crs), there = Crs::parse(fileCrs);
    if (!here || !there)
        return (here ? there : here).problems();
    if (here.value().isSame(there.value()))
        return std::shared_ptr<const CrsMesh>();
    const glm::dvec2 origin(options.origin);
    const auto mesh =
        CrsMesh::makeLinear(here.value(), there.value(), origin + options.low, origin + options.high);
    if (!mesh)
        return mesh.problems();
    return std::make_shared<const CrsMesh>(mesh.value());
}

/// Applies the options `height` and `roughness`: a single layer gets a height above the ground and a profile.
Diagnostics applyProfile(const WindFileOptions& options, GridWind::Grid& grid) {
    const bool isLayer = !grid.aboveGround && grid.points.z == 1;
    if (options.roughness == 0.0 && options.height == 0.0)
        return {};
    if (!isLayer && options.height > 0.0)
        return {keyProblem("height", "the data already contain their heights")};
    if (!isLayer && !grid.aboveGround)
        return {keyProblem("roughness", "the heights of the data are not above the ground")};
    if (!(options.roughness > 0.0) || (isLayer && !(options.height > 0.0)))
        return {keyProblem(isLayer ? "height" : "roughness",
                           "expected both the height of the data above the ground and a roughness length")};
    if (isLayer)
        grid.heights = {static_cast<float>(options.height)};
    grid.aboveGround = true;
    grid.roughness = options.roughness;
    return {};
}

/// Converts a grid to a wind in the scene.
Result<WindFile> makeGridFile(WindContent&& content, const WindFileOptions& options,
                              const std::string& path) {
    auto& grid = std::get<GridWind::Grid>(content.data);
    const auto transform = meshToFile(content.summary.crs, options);
    if (!transform)
        return fileProblem(path, transform.problems().front().message);
    const std::shared_ptr<const CrsMesh>& mesh = transform.value();
    const glm::dvec2 origin(options.origin), itsOrigin = mesh ? mesh->transformed(origin) : origin;
    if (mesh && mesh->isDegrees()) {
        const double middle = grid.origin.x + 0.5 * grid.cell.x * (grid.points.x - 1);
        grid.origin.x += longitudeWrap(middle, itsOrigin.x);
    }
    if (Diagnostics problems = applyProfile(options, grid); !problems.empty())
        return problems;
    WindFile file;
    summarize(grid, content.summary);
    WindExtent extent = content.fileExtent.value_or(extentOf(content.summary));
    if (mesh && mesh->isDegrees() && !extent.isUnbounded(0)) {
        const double turns = longitudeWrap(0.5 * (extent.low.x + extent.high.x), itsOrigin.x);
        extent.low.x += turns;
        extent.high.x += turns;
    }
    content.summary.extent = extent;
    file.covers = [mesh, origin, extent](const glm::dvec2& place) {
        return extent.contains(mesh ? mesh->transformed(origin + place) : origin + place);
    };
    file.summary = std::move(content.summary);
    moveOrigin(itsOrigin, options.origin.z, grid);
    Result<WindFieldPtr> field = withPath(GridWind::create(std::move(grid)), path);
    if (!field)
        return field.problems();
    file.wind = field.value();
    if (content.travelSpeed > 0.0) {
        file.wind.clock.origin.x = -itsOrigin.x;
        file.wind.clock.travel.x = content.travelSpeed;
    }
    if (mesh)
        setKnown(file.wind, {nullptr, DataTransform{mesh, origin, itsOrigin}});
    return file;
}

/// Converts a record at one point to a wind.
Result<WindFile> makeRecordFile(WindContent&& content, const WindFileOptions& options,
                                const std::string& path) {
    auto& series = std::get<WindSeries>(content.data);
    content.summary.times = series.times;
    if (options.roughness > 0.0)
        series.profile = LogProfile{options.height, options.roughness};
    const auto field = withPath(TimeSeriesWind::create(std::move(series)), path);
    if (!field)
        return field.problems();
    return WindFile{std::move(content.summary), field.value(), [](const glm::dvec2&) { return true; }};
}

/// Reads one file, with velocities converted to m/s.
/// @param secondFile file of the other component; empty if there is none.
Result<WindContent> readConverted(const std::string& path, const WindFileOptions& options,
                                  const std::string& secondFile = {}) {
    WindRequest request{options.columns, options.asStored, {}, secondFile, options.variable};
    if (!options.crs.empty())
        request.area = {options.crs, glm::dvec2(options.origin) + options.low,
                        glm::dvec2(options.origin) + options.high};
    request.columns.speedUnit = options.speedUnit;
    Result<WindContent> read = readWindContent(path, request);
    if (!read)
        return read;
    if (Diagnostics problems = convertVelocities(read.value(), options.speedUnit, path); !problems.empty())
        return problems;
    const std::string& crs = read.value().summary.crs;
    if (options.crs.empty() && !options.asStored && !crs.empty() && Crs::parse(crs).value().isDegrees())
        return fileProblem(path, "its coordinates are in degrees, " + read.value().summary.coordinates +
                                     "; expected crs, a projected CRS in metres");
    return read;
}

/// Converts file content to a wind. @param path of the first file.
Result<WindFile> makeWindFile(Result<WindContent>&& read, const std::string& path,
                              const WindFileOptions& options) {
    if (!read)
        return read.problems();
    WindContent& content = read.value();
    std::vector<std::string>& notes = content.summary.notes;
    for (std::string* text : {&content.summary.unit, &content.summary.coordinates})
        *text = asUtf8(std::move(*text));
    notes.insert(notes.end(), content.assumptions.begin(), content.assumptions.end());
    noteMissing(content, notes);
    if (std::holds_alternative<WindSeries>(content.data))
        return makeRecordFile(std::move(content), options, path);
    return makeGridFile(std::move(content), options, path);
}

Diagnostics check(const WindFileOptions& options) {
    if (!options.speedUnit.empty())
        if (const Result<double> unit = sizeOfUnit(Dimension::Speed, options.speedUnit); !unit)
            return {keyProblem("speedUnit", unit.problems().front().message)};
    if (options.crs.empty())
        return {};
    const Result<Crs> crs = Crs::parseMap(options.crs);
    return crs ? Diagnostics() : crs.problems();
}

} // namespace

Result<WindFile> readWindFile(const std::string& path, const WindFileOptions& options) {
    const auto maps = MapProgram::shared();
    if (Diagnostics problems = check(options); !problems.empty())
        return problems;
    return makeWindFile(readConverted(path, options), path, options);
}

Result<WindFile> readWindFiles(const std::vector<std::string>& files, const std::vector<double>& times,
                               const WindFileOptions& options) {
    const auto maps = MapProgram::shared();
    if (Diagnostics problems = check(options); !problems.empty())
        return problems;
    std::map<std::string, std::string> partners; // the file of the other component by the first file
    std::optional<Result<WindContent>> first;
    std::vector<std::string> moments = files;
    if (files.size() > 1) {
        first = readConverted(files[0], options);
        if (!*first && files.size() % 2 == 0)
            if (Result<WindContent> pair = readConverted(files[0], options, files[1])) {
                first = std::move(pair);
                moments.clear();
                for (std::size_t i = 0; i < files.size(); i += 2) {
                    moments.push_back(files[i]);
                    partners[files[i]] = files[i + 1];
                }
            }
    }
    const auto read = [&](const std::string& file) {
        Result<WindContent> step = first ? std::move(*first) : readConverted(file, options, partners[file]);
        first.reset();
        if (const auto* grid = step ? std::get_if<GridWind::Grid>(&step.value().data) : nullptr)
            if (Diagnostics problems = withPath(GridWind::check(*grid), file); !problems.empty())
                return Result<WindContent>(problems); // reports problems by file, before the steps are joined
        return step;
    };
    Result<WindContent> wind = readWindSteps(moments, times, read);
    if (wind && moments.size() < files.size())
        wind.value().summary.notes.push_back("components are read from pairs of files");
    return makeWindFile(std::move(wind), files.empty() ? "" : files.front(), options);
}

Result<WindSeries> readWindSeries(const std::string& path, const WindSeriesColumns& columns,
                                  std::vector<std::string>* notes) {
    Result<WindContent> read = readWindContent(path, {columns, false, {}, {}, {}});
    if (!read)
        return read.problems();
    WindContent& content = read.value();
    auto* series = std::get_if<WindSeries>(&content.data);
    if (!series)
        return fileProblem(path, "expected a record at one point, found a grid: " + content.summary.format);
    if (Diagnostics problems = convertVelocities(content, columns.speedUnit, path); !problems.empty())
        return problems;
    noteMissing(content, content.assumptions);
    series->date = parseDate(content.summary.start);
    if (notes)
        *notes = std::move(content.assumptions);
    return std::move(*series);
}

} // namespace osgTreeWind
