// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/TomlText.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/wind/ThesisWind.h>
#include <osgTreeWind/wind/TimeSeriesWind.h>
#include <osgTreeWind/wind/UniformWind.h>
#include <osgTreeWind/wind/WindFiles.h>
#include <osgTreeWind/wind/WindKeys.h>

#include <filesystem>
#include <utility>

namespace osgTreeWind {

namespace {

/// Writes a wind. @return why it cannot be written; empty on success.
class WindWriter {
public:
    WindWriter(std::ostream& output, const ForestDescription& forest) : _output(output), _forest(forest) {}

    /// Writes the field, the gusts, the clock and the adjustment.
    std::string write(const Wind& wind) {
        const WindFiles* const files = filesOf(wind);
        std::string problem = files ? writeFiles(*files) : writeField(*wind.field, wind.gusts);
        if (!areKeysEqual(wind.gusts, WindGusts()))
            keepFirst(problem, keys(wind.gusts));
        const WindClock defaults;
        if (wind.clock.start != defaults.start || wind.clock.scale != defaults.scale)
            keepFirst(problem, keys(wind.clock));
        if (!wind.adjustment.isIdentity())
            keepFirst(problem, keys(wind.adjustment));
        const bool isFromFile = files && !dynamic_cast<const TimeSeriesWind*>(wind.field.get());
        if (wind.clock.travels() && !isFromFile)
            key("travel", tomlText(std::vector<double>{wind.clock.travel.x, wind.clock.travel.y}));
        if (!files && mapOf(wind))
            keepFirst(problem, "a wind with its own map that was not read from a file");
        return problem;
    }

private:
    std::string writeField(const WindField& field, const WindGusts& gusts) {
        if (const auto* uniform = dynamic_cast<const UniformWind*>(&field)) {
            kind(gusts.intensity > 0.0 || uniform->profile() ? "gusts" : "uniform");
            key("velocity", tomlText(uniform->velocity()));
            if (uniform->profile() && areKeysEqual(gusts, WindGusts()))
                key("intensity", tomlText(0.0));
            for (const float speed : {uniform->velocity().x, uniform->velocity().y, uniform->velocity().z})
                if (!windSpeeds.contains(static_cast<double>(speed)))
                    return "velocity: expected a finite number " + windSpeeds.text();
            return profile(uniform->profile());
        }
        if (const auto* grid = dynamic_cast<const GridWind*>(&field))
            return kind("grid"), keys(grid->grid());
        if (const auto* thesis = dynamic_cast<const ThesisWind*>(&field))
            return kind("forest_wind"), keys(thesis->array());
        if (const auto* record = dynamic_cast<const TimeSeriesWind*>(&field))
            return kind("series"), keys(record->series()) + profile(record->series().profile);
        return "this wind cannot be written to a file: expected a uniform one, a grid, a series or one from "
               "a file, not a callable or streamed one";
    }
    template <typename T>
    void key(const char* name, const T& text) {
        _output << name << " = " << text << '\n';
    }
    void kind(const char* name) { _output << "kind = \"" << name << "\"\n"; }

    /// Writes all keys of a struct. @return the first problem with their values.
    template <typename Struct>
    std::string keys(const Struct& value) {
        Diagnostics problems;
        checkKeys(value, "", problems);
        writeKeys(_output, "wind", keysOf<Struct>(), &value, nullptr);
        return problems.empty() ? "" : problems.front().text();
    }
    std::string profile(const std::optional<LogProfile>& profile) {
        return profile ? keys(*profile) : std::string();
    }

    static void keepFirst(std::string& problem, std::string&& next) {
        if (problem.empty())
            problem = std::move(next);
    }

    std::string writeFiles(const WindFiles& source) {
        kind("file");
        std::vector<std::string> files;
        for (const std::string& file : source.files) {
            if (std::string problem = problemOfFile(file); !problem.empty())
                return problem;
            files.push_back(absolutePath(file));
        }
        if (source.series)
            key("files", tomlText(files));
        else
            key("file", tomlText(files.front()));
        if (!source.times.empty())
            key("times", tomlText(source.times));
        key("offset", tomlText(source.offset));
        if (!source.speedUnit.empty())
            key("speed_unit", tomlText(source.speedUnit));
        if (!source.variable.empty())
            key("variable", tomlText(source.variable));
        if (source.roughness > 0.0)
            key("roughness", tomlText(source.roughness));
        if (source.height > 0.0)
            key("height", tomlText(source.height));
        if (source.allowsOutside)
            key("beyond", tomlText(std::string("hold")));
        if (source.crs != _forest.crs)
            return "it was read for a forest with another crs";
        return source.origin == _forest.origin ? "" : "it was read for a forest with another origin";
    }

    std::ostream& _output;
    const ForestDescription& _forest;
};

} // namespace

std::string writeWind(std::ostream& output, const ForestDescription& forest) {
    const Wind& wind = forest.wind;
    CanopySettings defaults;
    if (wind.isCalm() && areKeysEqual(forest.canopy, defaults))
        return {};
    output << "\n[wind]\n";
    std::string problem;
    if (wind.field)
        problem = WindWriter(output, forest).write(wind);
    else
        output << "kind = \"calm\"\n";
    for (const auto& [name, frame] : windFrames())
        if (frame == wind.frame && frame != WindFrame::Forest)
            output << "frame = " << tomlText(name) << '\n';
    if (forest.canopy.source == CanopySource::None)
        defaults.source = CanopySource::Forest; // always written, because a reader would decide it
    writeKeys(output, "wind", keysOf<CanopySettings>(), &forest.canopy, &defaults);
    for (std::size_t i = 0; problem.empty() && i < wind.sources.size(); ++i) {
        output << "\n[[wind.source]]\n";
        Diagnostics problems;
        checkKeys(wind.sources[i], "source", problems);
        writeKeys(output, "wind.source", keysOf<WindSource>(), &wind.sources[i], nullptr);
        problem = problems.empty() ? "" : problems.front().text();
    }
    return problem;
}

} // namespace osgTreeWind
