// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/wind/FileWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindFields.h>
#include <osgTreeWind/wind/WindWithSources.h>

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
            return kind("uniform"), ofUniform(uniform->velocity());
        if (const auto gusts = dynamic_cast<const GustWind*>(&wind))
            return kind("gusts"), ofGusts(gusts->parameters());
        if (const auto grid = dynamic_cast<const GridWind*>(&wind))
            return kind("grid"), fields(grid->grid());
        if (const auto array = dynamic_cast<const ForestWind*>(&wind))
            return kind("forest_wind"), fields(array->array());
        if (const auto record = dynamic_cast<const TimeSeriesWind*>(&wind))
            return kind("series"), fields(record->series()) + profile(record->series().profile);
        if (const auto file = dynamic_cast<const FileWind*>(&wind))
            return kind("file"), ofFiles(file->source());
        if (const auto retimed = dynamic_cast<const RetimedWind*>(&wind))
            return ofRetimed(*retimed);
        if (const auto adjusted = dynamic_cast<const AdjustedWind*>(&wind)) {
            const std::string problem = fields(adjusted->adjustment());
            return problem.empty() ? write(*adjusted->inner()) : problem;
        }
        if (dynamic_cast<const WindWithSources*>(&wind))
            return "a wind with sources within another one";
        return "a wind that no file can say: expected a uniform one, gusts, a grid, a series or one from a "
               "file, not a callable, streamed or moved one";
    }

private:
    template <typename T>
    void key(const char* name, const T& text) {
        _output << name << " = " << text << '\n';
    }
    void kind(const char* name) { _output << "kind = \"" << name << "\"\n"; }

    /// All fields of a struct. @return the first one that is out of range.
    template <typename Struct>
    std::string fields(const Struct& value) {
        Diagnostics problems;
        checkFields(value, "", problems);
        writeFields(_output, "wind", fieldsOf<Struct>(), &value, nullptr);
        return problems.empty() ? "" : problems.front().text();
    }
    std::string profile(const std::optional<LogProfile>& profile) {
        return profile ? fields(*profile) : std::string();
    }

    std::string ofUniform(const glm::vec3& velocity) {
        key("velocity", tomlText(velocity));
        for (const float speed : {velocity.x, velocity.y, velocity.z})
            if (!windSpeeds.contains(static_cast<double>(speed)))
                return "velocity: expected a finite number " + windSpeeds.text();
        return {};
    }

    std::string ofGusts(const GustWind::Parameters& gusts) {
        key("velocity", tomlText(gusts.mean));
        return fields(gusts) + profile(gusts.profile);
    }

    std::string ofFiles(const FileWind::Source& source) {
        std::vector<std::string> files;
        for (const std::string& file : source.files) {
            if (std::string problem = problemOfFile(file); !problem.empty())
                return problem;
            files.push_back(std::filesystem::absolute(file).string());
        }
        if (source.series)
            key("files", tomlText(files));
        else
            key("file", tomlText(files.front()));
        if (!source.times.empty())
            key("times", tomlText(source.times));
        key("offset", tomlText(source.offset));
        key("speed_unit", tomlText(source.speedUnit));
        if (source.roughness > 0.0)
            key("roughness", tomlText(source.roughness));
        if (source.height > 0.0)
            key("height", tomlText(source.height));
        if (source.crs != _forest.crs)
            return "it was read for a forest with another crs";
        return source.origin == _forest.origin ? "" : "it was read for a forest with another origin";
    }

    std::string ofRetimed(const RetimedWind& wind) {
        if (std::isfinite(wind.clock().speed))
            return "a wind carried past a plane that was not read from a file";
        const std::string problem = fields(wind.clock());
        return problem.empty() ? write(*wind.inner()) : problem;
    }

    std::ostream& _output;
    const ForestDescription& _forest;
};

} // namespace

std::string writeWind(std::ostream& output, const ForestDescription& forest) {
    const WindCanopy usual;
    const Fields& canopy = fieldsOf<WindCanopy>();
    const bool alone = std::all_of(canopy.begin(), canopy.end(), [&](const Field& field) {
        return sameField(field, &forest.windCanopy, &usual);
    });
    if (!forest.wind && alone)
        return {};
    const auto* const sourced = dynamic_cast<const WindWithSources*>(forest.wind.get());
    const WindField* const wind = sourced ? sourced->wind().get() : forest.wind.get();
    output << "\n[wind]\n";
    writeFields(output, "wind", canopy, &forest.windCanopy, &usual);
    for (const auto& [name, frame] : windFrames())
        if (frame == forest.windFrame && frame != WindFrame::Forest)
            output << "frame = " << tomlText(name) << '\n';
    std::string problem;
    if (wind)
        problem = WindWriter(output, forest).write(*wind);
    else
        output << "kind = \"calm\"\n";
    for (std::size_t i = 0; sourced && problem.empty() && i < sourced->sources().size(); ++i) {
        output << "\n[[wind.source]]\n";
        Diagnostics problems;
        checkFields(sourced->sources()[i], "source", problems);
        writeFields(output, "wind.source", fieldsOf<WindSource>(), &sourced->sources()[i], nullptr);
        problem = problems.empty() ? "" : problems.front().text();
    }
    return problem;
}

} // namespace osgTreeWind
