// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/WindSteps.h>

#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/Problem.h>
#include <osgTreeWind/wind/SampleTimes.h>

#include <algorithm>

namespace osgTreeWind {

namespace {

std::string text(const glm::dvec3& v) {
    return numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z);
}

/// What a wind must be to be one step of several; empty when it is.
std::string problemOfStep(const WindContent& step) {
    const auto* grid = std::get_if<GridWind::Grid>(&step.data);
    const std::string expected = "expected a grid at one time, found ";
    if (!grid)
        return expected + "a record at one point";
    if (step.travelSpeed > 0.0)
        return expected + "one that drifts with the wind";
    if (grid->times.size() > 1)
        return expected + std::to_string(grid->times.size()) + " times";
    return {};
}

/// What of a step is not as in the first one; empty when all is.
std::string difference(const WindContent& first, const WindContent& step, const std::string& firstFile) {
    const auto& a = std::get<GridWind::Grid>(first.data);
    const auto& b = std::get<GridWind::Grid>(step.data);
    const std::string properties[][3] = {
        {"points east, north and up", text(a.points), text(b.points)},
        {"first point", text(a.origin), text(b.origin)},
        {"distances between points", text(a.cell), text(b.cell)},
        {"coordinates", first.summary.coordinates, step.summary.coordinates},
        {"unit of speed", first.summary.unit, step.summary.unit},
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

/// Puts a step behind those before. False when its layers are not at their heights.
bool append(GridWind::Grid& grid, const GridWind::Grid& step) {
    const std::size_t points = step.values.size() / 3;
    const bool ofPoints =
        step.heights.size() == points && !grid.heights.empty() && grid.heights.size() % points == 0;
    if (!ofPoints && step.heights != grid.heights)
        return false;
    if (ofPoints)
        grid.heights.insert(grid.heights.end(), step.heights.begin(), step.heights.end());
    grid.values.insert(grid.values.end(), step.values.begin(), step.values.end());
    return true;
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
    std::vector<double> ofFiles;
    std::vector<std::string> ofFirst; // notes
    for (const std::string& file : files) {
        Result<WindContent> one = read(file);
        if (!one)
            return one.problems();
        WindContent& step = one.value();
        if (const std::string what = problemOfStep(step); !what.empty())
            return fileProblem(file, what);
        if (times.empty()) {
            const std::vector<double>& own = std::get<GridWind::Grid>(step.data).times;
            if (own.empty())
                return keyProblem("times", "expected times, one for each file: " + file +
                                               " does not say when it holds");
            if (!ofFiles.empty() && own.front() <= ofFiles.back())
                return fileProblem(file, "expected a time after " + numberText(ofFiles.back()) +
                                             " s, that of the file before; found " + numberText(own.front()) +
                                             " s");
            ofFiles.push_back(own.front());
        }
        if (&file == &files.front()) {
            wind = std::move(step);
            ofFirst = wind.summary.notes;
            continue;
        }
        if (const std::string what = difference(wind, step, files.front()); !what.empty())
            return fileProblem(file, what);
        if (!append(std::get<GridWind::Grid>(wind.data), std::get<GridWind::Grid>(step.data)))
            return fileProblem(file, "expected the heights of " + files.front());
        const std::string source = file + ": ";
        for (const std::string& note : step.summary.notes)
            if (std::find(ofFirst.begin(), ofFirst.end(), note) == ofFirst.end())
                wind.summary.notes.push_back(source + note);
        wind.missing += step.missing;
        wind.summary.slowest = std::min(wind.summary.slowest, step.summary.slowest);
        wind.summary.fastest = std::max(wind.summary.fastest, step.summary.fastest);
    }
    auto& all = std::get<GridWind::Grid>(wind.data).times;
    all = times.empty() ? ofFiles : times;
    if (all.front() != 0.0)
        wind.summary.start.clear(); // which was that of the first file
    return wind;
}

} // namespace osgTreeWind
