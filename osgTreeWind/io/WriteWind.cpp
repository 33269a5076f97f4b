// SPDX-License-Identifier: MIT
#include <osgTreeWind/forest/ForestFields.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/MessageText.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/wind/FileWind.h>
#include <osgTreeWind/wind/ForestWind.h>
#include <osgTreeWind/wind/GridWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindFields.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace osgTreeWind {

namespace {

/// Writes one kind of wind, and gives what keeps it from that.
class WindWriter {
public:
    WindWriter(std::ostream& output, const ForestDescription& forest) : _output(output), _forest(forest) {}

    std::string write(const WindField& wind) {
        if (const auto uniform = dynamic_cast<const UniformWind*>(&wind))
            return ofUniform(*uniform);
        if (const auto gusts = dynamic_cast<const GustWind*>(&wind))
            return ofGusts(gusts->parameters());
        if (const auto grid = dynamic_cast<const GridWind*>(&wind))
            return ofGrid(grid->grid());
        if (const auto array = dynamic_cast<const ForestWind*>(&wind))
            return ofArray(*array);
        if (const auto series = dynamic_cast<const TimeSeriesWind*>(&wind))
            return ofSeries(series->series());
        if (const auto file = dynamic_cast<const FileWind*>(&wind))
            return ofFiles(file->source());
        if (const auto retimed = dynamic_cast<const RetimedWind*>(&wind))
            return ofRetimed(*retimed);
        return "a wind that no file can say: expected a uniform one, gusts, a grid, a series or one from a "
               "file, not a callable, streamed or moved one";
    }

private:
    template <typename T>
    void key(const char* name, const T& text) {
        _output << name << " = " << text << '\n';
    }
    void kind(const char* name) { _output << "kind = \"" << name << "\"\n"; }

    /// Empty when all are.
    template <typename Numbers>
    static std::string within(const Range& range, const char* what, const Numbers& numbers) {
        for (const auto number : numbers)
            if (!range.contains(static_cast<double>(number)))
                return std::string(what) + ": expected a finite number " + range.text();
        return {};
    }
    static std::string within(const Range& range, const char* what, const glm::vec3& v) {
        return within(range, what, std::vector<float>{v.x, v.y, v.z});
    }

    std::string ofUniform(const UniformWind& wind) {
        kind("uniform");
        key("velocity", tomlVector(wind.velocity()));
        return within(windSpeeds, "velocity", wind.velocity());
    }

    std::string ofProfile(const std::optional<LogProfile>& profile) {
        Diagnostics problems;
        if (profile) {
            checkFields(*profile, "", problems);
            writeFields(_output, "wind", fieldsOf<LogProfile>(), &*profile, nullptr);
        }
        return problems.empty() ? "" : problems.front().text();
    }

    std::string ofGusts(const GustWind::Parameters& gusts) {
        kind("gusts");
        key("velocity", tomlVector(gusts.mean));
        writeFields(_output, "wind", fieldsOf<GustWind::Parameters>(), &gusts, nullptr);
        return ofProfile(gusts.profile);
    }

    std::string ofGrid(const GridWind::Grid& grid) {
        kind("grid");
        key("corner", tomlVector(grid.origin));
        key("points", '[' + std::to_string(grid.points.x) + ", " + std::to_string(grid.points.y) + ", " +
                          std::to_string(grid.points.z) + ']');
        key("cell", tomlVector(grid.cell));
        if (!grid.times.empty())
            key("times", tomlArray(grid.times));
        if (!grid.heights.empty())
            key("heights", tomlArray(grid.heights));
        key("values", tomlArray(grid.values));
        const std::string sizes =
            within(gridPoints, "points", std::vector<int>{grid.points.x, grid.points.y, grid.points.z}) +
            within(gridCells, "cell", std::vector<double>{grid.cell.x, grid.cell.y, grid.cell.z});
        return sizes.empty() ? ofPlace(grid.origin, grid.values) : sizes;
    }

    static std::string ofPlace(const glm::dvec3& corner, const std::vector<float>& values) {
        const std::string problem =
            within(worldCoordinates, "corner", std::vector<double>{corner.x, corner.y, corner.z});
        return problem.empty() ? within(windSpeeds, "values", values) : problem;
    }

    std::string ofArray(const ForestWind& wind) {
        kind("forest_wind");
        key("corner", tomlVector(wind.origin()));
        key("width", wind.width());
        key("length", wind.length());
        key("values", tomlArray(wind.values()));
        const std::string problem =
            within(gridPoints, "width, length", std::vector<int>{wind.width(), wind.length()});
        return problem.empty() ? ofPlace(wind.origin(), wind.values()) : problem;
    }

    std::string ofSeries(const WindSeries& series) {
        kind("series");
        key("times", tomlArray(series.times));
        _output << "velocities = [\n";
        for (const glm::vec3& velocity : series.velocities) {
            _output << "    " << tomlVector(velocity) << ",\n";
            if (std::string problem = within(windSpeeds, "velocities", velocity); !problem.empty())
                return problem;
        }
        _output << "]\n";
        key("repeat", series.repeat ? "true" : "false");
        return ofProfile(series.profile);
    }

    std::string ofFiles(const FileWind::Source& source) {
        kind("file");
        std::vector<std::string> files;
        for (const std::string& file : source.files) {
            std::error_code error;
            if (!isUtf8(file) || !std::filesystem::is_regular_file(file, error))
                return "no file " + inQuotes(file);
            files.push_back(std::filesystem::absolute(file).string());
        }
        if (source.series)
            key("files", tomlArray(files));
        else
            key("file", tomlText(files.front()));
        if (!source.times.empty())
            key("times", tomlArray(source.times));
        key("offset", tomlVector(source.offset));
        key("speed_unit", tomlText(source.speedUnit));
        return source.origin == _forest.origin ? "" : "it was read for a forest with another origin";
    }

    std::string ofRetimed(const RetimedWind& wind) {
        Diagnostics problems;
        checkFields(wind.clock(), "", problems);
        if (!problems.empty())
            return problems.front().text();
        if (std::isfinite(wind.clock().speed))
            return "a wind carried past a plane that was not read from a file";
        if (dynamic_cast<const RetimedWind*>(wind.inner().get()))
            return "a retimed wind of a retimed one";
        writeFields(_output, "wind", wind.clock());
        return write(*wind.inner());
    }

    std::ostream& _output;
    const ForestDescription& _forest;
};

} // namespace

std::string writeWind(std::ostream& output, const ForestDescription& forest) {
    if (!forest.wind)
        return {};
    output << "\n[wind]\n";
    return WindWriter(output, forest).write(*forest.wind);
}

} // namespace osgTreeWind
