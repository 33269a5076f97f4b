// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindSteps.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/WindLimits.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

std::string text(const glm::dvec3& v) {
    return numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z);
}

/// Why a wind cannot be a time step; empty if it can. @param isTimed whether one time is given for each file.
std::string problemOfStep(const WindContent& step, bool isTimed) {
    const auto* grid = std::get_if<GridWind::Grid>(&step.data);
    const std::string expected = isTimed ? "expected a grid at one time, found " : "expected a grid, found ";
    if (!grid)
        return expected + "a record at one point";
    if (step.travelSpeed > 0.0)
        return expected + "one that drifts with the wind";
    if (isTimed && grid->times.size() > 1)
        return expected + std::to_string(grid->times.size()) + " times";
    return {};
}

std::string heightDatum(const GridWind::Grid& grid) {
    return grid.aboveGround ? "the ground" : "that of the file";
}

/// How a step differs from the first one; empty if it does not.
std::string difference(const WindContent& first, const WindContent& step, const std::string& firstFile) {
    const auto& a = std::get<GridWind::Grid>(first.data);
    const auto& b = std::get<GridWind::Grid>(step.data);
    const std::string properties[][3] = {
        {"points east, north and up", text(a.points), text(b.points)},
        {"first point", text(a.origin), text(b.origin)},
        {"distances between points", text(a.cell), text(b.cell)},
        {"coordinates", first.summary.coordinates, step.summary.coordinates},
        {"unit of speed", first.summary.unit, step.summary.unit},
        {"zero of heights", heightDatum(a), heightDatum(b)},
        {"turbulence", a.deviations.empty() ? "" : "known", b.deviations.empty() ? "" : "known"},
    };
    for (const auto& [name, expected, found] : properties) {
        if (expected == found)
            continue;
        std::string what = "the " + name;
        what += " of " + firstFile + ", " + (expected.empty() ? "none" : expected);
        return expectedFound(what, found);
    }
    return {};
}

std::size_t valueCount(const WindContent& step) {
    return std::get<GridWind::Grid>(step.data).values.size();
}

/// Repeats the heights of points for each time of a grid, if they are stored only once.
void repeatHeights(GridWind::Grid& grid, std::size_t points) {
    const std::vector<float> once = grid.heights;
    while (once.size() == points && grid.heights.size() < grid.values.size() / 3)
        grid.heights.insert(grid.heights.end(), once.begin(), once.end());
}

/// Appends a step to a grid. @return false if their layers have different heights.
bool append(GridWind::Grid& grid, GridWind::Grid& step) {
    const glm::dvec3 size(step.points);
    const auto points = static_cast<std::size_t>(size.x * size.y * size.z);
    if (step.heights != grid.heights) {
        if (grid.heights.size() < points || step.heights.size() < points)
            return false;
        repeatHeights(grid, points);
        repeatHeights(step, points);
        grid.heights.insert(grid.heights.end(), step.heights.begin(), step.heights.end());
    } else if (grid.heights.size() > points)
        grid.heights.insert(grid.heights.end(), step.heights.begin(), step.heights.end());
    grid.values.insert(grid.values.end(), step.values.begin(), step.values.end());
    grid.deviations.insert(grid.deviations.end(), step.deviations.begin(), step.deviations.end());
    return true;
}

/// Times of a file.
struct FileTimes {
    std::vector<double> seconds; ///< Since 1970 if dated; empty if the file contains no time.
    bool isDated = false;
};

FileTimes timesOf(const WindContent& step) {
    FileTimes times{std::get<GridWind::Grid>(step.data).times, false};
    const auto start = parseDate(step.summary.start);
    if (!start)
        return times;
    times.isDated = true;
    if (times.seconds.empty())
        times.seconds = {0.0};
    for (double& seconds : times.seconds)
        seconds += *start;
    return times;
}

/// Appends the times of the next file to those of the previous ones.
Diagnostics appendTimes(const std::string& file, const FileTimes& own, FileTimes& all) {
    if (own.seconds.empty())
        return {
            keyProblem("times", "expected one time for each file, because " + file + " contains no time")};
    if (all.seconds.empty())
        all.isDated = own.isDated;
    else if (own.isDated != all.isDated)
        return {fileProblem(file, all.isDated ? "expected a date, as in the first file"
                                              : "expected seconds, as in the first file, found a date")};
    else if (own.seconds.front() <= all.seconds.back()) {
        const double zero = all.isDated ? all.seconds.front() : 0.0;
        return {fileProblem(file, "expected a time after " + numberText(all.seconds.back() - zero) +
                                      " s, the last time of the previous file, found " +
                                      numberText(own.seconds.front() - zero) + " s")};
    }
    all.seconds.insert(all.seconds.end(), own.seconds.begin(), own.seconds.end());
    return {};
}

/// Appends the velocities of the next file. @return why they do not fit; empty if they do.
std::string appendVelocities(WindContent& wind, WindContent& step, const std::string& firstFile) {
    if (const std::string what = difference(wind, step, firstFile); !what.empty())
        return what;
    if (const std::string what = problemOfMemory("all files up to this one",
                                                 sizeof(float) * (valueCount(wind) + valueCount(step)));
        !what.empty())
        return what;
    if (!append(std::get<GridWind::Grid>(wind.data), std::get<GridWind::Grid>(step.data)))
        return "expected the heights of " + firstFile;
    wind.missingCount += step.missingCount;
    wind.summary.slowest = std::min(wind.summary.slowest, step.summary.slowest);
    wind.summary.fastest = std::max(wind.summary.fastest, step.summary.fastest);
    return {};
}

} // namespace

Result<WindContent> readWindSteps(const std::vector<std::string>& files, const std::vector<double>& times,
                                  const std::function<Result<WindContent>(const std::string&)>& read) {
    if (files.empty())
        return keyProblem("files", "expected at least one");
    if (!times.empty() && times.size() != files.size())
        return keyProblem("times", "expected " + std::to_string(files.size()) +
                                       " numbers, one for each file, found " + std::to_string(times.size()));
    if (Diagnostics problems = checkTimes(times); !problems.empty())
        return problems;

    WindContent wind;
    FileTimes fileTimes;
    std::vector<std::string> firstNotes;
    for (const std::string& file : files) {
        Result<WindContent> one = read(file);
        if (!one)
            return one.problems();
        WindContent& step = one.value();
        if (const std::string what = problemOfStep(step, !times.empty()); !what.empty())
            return fileProblem(file, what);
        const FileTimes own = timesOf(step);
        if (times.empty() && files.size() == 1 && own.seconds.empty())
            return one; // a steady wind
        if (times.empty())
            if (Diagnostics problems = appendTimes(file, own, fileTimes); !problems.empty())
                return problems;
        if (&file == &files.front()) {
            wind = std::move(step);
            firstNotes = wind.summary.notes;
            continue;
        }
        if (const std::string what = appendVelocities(wind, step, files.front()); !what.empty())
            return fileProblem(file, what);
        for (const std::string& note : step.summary.notes)
            if (std::find(firstNotes.begin(), firstNotes.end(), note) == firstNotes.end())
                wind.summary.notes.push_back(file + ": " + note);
    }
    const double zero = fileTimes.isDated ? fileTimes.seconds.front() : 0.0;
    for (double& seconds : fileTimes.seconds)
        seconds -= zero;
    auto& all = std::get<GridWind::Grid>(wind.data).times;
    all = times.empty() ? fileTimes.seconds : times;
    if (all.front() != 0.0)
        wind.summary.start.clear(); // the date of the first file is not time 0
    return wind;
}

} // namespace osgTreeWind
