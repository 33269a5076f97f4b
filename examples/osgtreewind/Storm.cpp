// SPDX-License-Identifier: MIT
#include "Command.h"
#include "OneTree.h"

#include <osgTreeWind/motion/sway/PullAndRelease.h>
#include <osgTreeWind/motion/sway/StormTree.h>
#include <osgTreeWind/motion/sway/SwayFeatures.h>

#include <glm/geometric.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>

namespace {

using namespace osgTreeWind;

constexpr double settling = 60.0; // seconds before the first that counts

struct StormOptions : OneTree {
    double spacing = 0.0, speed = 10.0, duration = 3600.0, step = 0.125;
    std::uint32_t seed = 1;
    std::string trace;
    bool json = false;
};

/// Mean, deviation and largest of the way along and across the wind together.
class Extent {
public:
    void add(const glm::dvec2& value) {
        _sum += value;
        _squares += glm::dot(value, value);
        _max = std::max(_max, glm::length(value));
        ++_count;
    }
    double mean() const { return glm::length(_sum) / count(); }
    double deviation() const { return std::sqrt(std::max(_squares / count() - mean() * mean(), 0.0)); }
    double max() const { return _max; }
    nlohmann::ordered_json json() const { return {{"mean", mean()}, {"sd", deviation()}, {"max", _max}}; }

private:
    double count() const { return static_cast<double>(std::max<std::size_t>(_count, 1)); }

    glm::dvec2 _sum{0.0};
    double _squares = 0.0, _max = 0.0;
    std::size_t _count = 0;
};

void writeRow(std::FILE* trace, double time, const StormMoment& m) {
    std::fprintf(trace, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", time, m.wind.x, m.wind.y,
                 m.strain.x, m.strain.y, m.tilt.x, m.tilt.y, m.tip.x, m.tip.y);
}

/// Null where there are none.
nlohmann::ordered_json json(const std::optional<SwayFeatures>& features) {
    if (!features)
        return nullptr;
    nlohmann::ordered_json object{{"snr", features->signalToNoise},
                                  {"f0_hz", features->frequency},
                                  {"damping", nullptr},
                                  {"skewness", features->skewness},
                                  {"kurtosis", features->kurtosis},
                                  {"p999_over_sd", features->peak},
                                  {"f0_share", features->share},
                                  {"along_over_across", features->alongOverAcross}};
    if (features->damping)
        object["damping"] = *features->damping;
    return object;
}

void print(const StormOptions& options, const Species& species, const Extent& moment, const Extent& tip,
           const std::optional<FreeSway>& free, const std::optional<SwayFeatures>& features) {
    if (!options.json) {
        std::printf("%s, %.4g cm, %.4g m, %s, %.4g m/s at the top\n", species.name.c_str(), options.diameter,
                    options.height, options.open ? "in the open" : "in a stand", options.speed);
        std::printf("            mean        sd       max\n");
        std::printf("moment %9.4g %9.4g %9.4g N m at the ground\n", moment.mean(), moment.deviation(),
                    moment.max());
        std::printf("tip    %9.4g %9.4g %9.4g m\n", tip.mean(), tip.deviation(), tip.max());
        return;
    }
    nlohmann::ordered_json object{{"species", species.name},    {"dbh_cm", options.diameter},
                                  {"height_m", options.height}, {"crown_width_m", options.crownWidth},
                                  {"spacing_m", nullptr},       {"leaves", options.leaves},
                                  {"speed_ms", options.speed},  {"moment", moment.json()},
                                  {"tip", tip.json()},          {"features", json(features)},
                                  {"frequency_hz", nullptr}};
    if (!options.open)
        object["spacing_m"] = options.spacing;
    if (free)
        object["frequency_hz"] = free->frequency;
    std::cout << object.dump(2) << '\n';
}

ExitCode storm(StormOptions options) {
    const Species species = options.kind();
    const TreePlacement tree = options.grown(species);
    if (options.spacing == 0.0)
        options.spacing = 0.886 * options.crownWidth; // their crowns are as large as the ground: sqrt(pi / 4)
    StormTree stormy(species, tree, {options.speed, options.open ? 0.0 : options.spacing, options.seed});
    std::FILE* trace = options.trace.empty() ? nullptr : std::fopen(options.trace.c_str(), "w");
    if (!options.trace.empty() && !trace) {
        std::cerr << options.trace << ": cannot be written\n";
        return Failed;
    }
    if (trace)
        std::fprintf(trace, "time,wind_x,wind_y,strain_x,strain_y,tilt_x,tilt_y,tip_x,tip_y\n");
    stormy.advance(settling);
    Extent moment, tip;
    std::vector<glm::dvec2> strains;
    const auto rows = static_cast<std::size_t>(std::llround(options.duration / options.step));
    for (std::size_t row = 1; row <= rows; ++row) {
        const double time = options.step * static_cast<double>(row);
        const StormMoment now = stormy.advance(settling + time);
        moment.add(now.moment);
        tip.add(glm::dvec2(now.tip));
        strains.push_back(now.strain);
        if (trace)
            writeRow(trace, time, now);
    }
    bool failed = trace && (std::fflush(trace) != 0 || std::ferror(trace) != 0);
    if (trace)
        failed |= std::fclose(trace) != 0;
    if (failed) {
        std::cerr << options.trace << ": writing failed\n";
        return Failed;
    }
    const std::optional<FreeSway> free = pullAndRelease(species, tree);
    print(options, species, moment, tip, free,
          free ? swayFeatures(strains, 1.0 / options.step, free->frequency) : std::nullopt);
    return Succeeded;
}

} // namespace

void addStormCommand(CLI::App& app, ExitCode& exitCode) {
    CLI::App* command = app.add_subcommand(
        "storm", "Stand one tree in a storm, among its like or alone, and measure its sway");
    auto options = std::make_shared<StormOptions>();
    addTreeOptions(*command, *options);
    command
        ->add_option("--spacing", options->spacing,
                     "From tree to tree of the stand, m; without it their crowns just fill the ground")
        ->check(within(0.1, 1000.0))
        ->excludes("--open");
    command
        ->add_option("--speed", options->speed,
                     "Mean wind at the top of the canopy, with --open at the top of the tree, m/s")
        ->check(within(0.0, 80.0))
        ->capture_default_str();
    command->add_option("--duration", options->duration, "Seconds that count, after a minute that does not")
        ->check(within(1.0, 1e6))
        ->capture_default_str();
    command->add_option("--step", options->step, "Seconds from row to row of the trace")
        ->check(within(1e-3, 0.125))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "One seed, one wind")->capture_default_str();
    command->add_option("-o,--output", options->trace, "CSV file for the trace of wind and sway");
    command->add_flag("--json", options->json, "Print an object instead of lines");
    command->footer(
        "The trace: time (s), wind at the top (m/s), strain of the wood at the foot of the trunk, tilt of "
        "the\n"
        "trunk at half its height (sine), shift of its top (m); x along the mean wind, y across it.\n"
        "Features are those of the strain, from twenty minutes on, at steps of 1/8 s or other parts of 1/4 "
        "s.\n"
        "Example: osgtreewind storm --species \"Sitka spruce\" --dbh 24 --height 20 --speed 10 --json");
    command->callback([options, &exitCode] { exitCode = storm(*options); });
}
