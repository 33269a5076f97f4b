// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/options/TreeRecord.h>
#include <examples/osgtreewind/options/TreeTable.h>
#include <examples/osgtreewind/output/AtomicTable.h>
#include <examples/osgtreewind/output/CommandError.h>
#include <examples/osgtreewind/output/Json.h>

#include <examples/osgtreewind/storm/StormTree.h>
#include <examples/osgtreewind/storm/SwayFeatures.h>
#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/motion/sway/PullAndRelease.h>

#include <glm/ext/scalar_constants.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <memory>
#include <optional>

namespace {

using namespace osgTreeWind;

constexpr double settlingTime = 60.0; // seconds before measuring starts
constexpr double minSpacing = 0.1;    // m

struct StormOptions : TreeRecord {
    double spacing = 0.0, basalArea = 0.0; ///< m and m²/ha; 0 if not given.
    double speed = 10.0, duration = 3600.0, step = 0.125;
    std::uint32_t seed = 1;
    std::string output, table;
    bool json = false, critical = true;
};

/// A tree with its options, ready to be simulated.
struct StormJob {
    StormOptions options;
    Species species;
    TreePlacement tree;

    StormJob(const StormOptions& given, Species kind)
        : options(given), species(std::move(kind)), tree(options.makePlacement(species)) {
        const double stem = 0.25e-4 * glm::pi<double>() * options.diameter * options.diameter; // m²
        if (options.basalArea > 0.0)
            options.spacing = 100.0 * std::sqrt(stem / options.basalArea);
        else if (options.spacing == 0.0) // crowns cover the ground: sqrt(pi / 4)
            options.spacing = 0.886 * options.crownWidth;
        if (given.basalArea > 0.0 && options.spacing < minSpacing)
            throw CommandError{BadInput, "basal area: expected at most " +
                                             numberText(1e4 * stem / (minSpacing * minSpacing)) +
                                             " m²/ha for stems of " + numberText(options.diameter) +
                                             " cm, found " + numberText(options.basalArea)};
        options.basalArea = 1e4 * stem / (options.spacing * options.spacing);
    }
};

/// Statistics of a vector along and across the wind: length of the mean, standard deviation, largest length.
class VectorStatistics {
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
    Json json() const { return {{"mean", mean()}, {"sd", deviation()}, {"max", _max}}; }

private:
    double count() const { return static_cast<double>(std::max<std::size_t>(_count, 1)); }

    glm::dvec2 _sum{0.0};
    double _squares = 0.0, _max = 0.0;
    std::size_t _count = 0;
};

void writeRow(std::FILE* trace, double time, const StormState& m) {
    std::fprintf(trace, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", time, m.wind.x, m.wind.y,
                 m.strain.x, m.strain.y, m.tilt.x, m.tilt.y, m.tip.x, m.tip.y);
}

Json json(const std::optional<SwayFeatures>& features) {
    if (!features)
        return nullptr;
    Json object{{"snr", features->signalToNoise},
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

Json json(const std::optional<double>& speed) {
    return speed ? Json(*speed) : nullptr;
}

/// Simulates the storm. @param trace file for the trace; may be null.
Json measureStorm(const StormJob& job, std::FILE* trace) {
    const StormOptions& options = job.options;
    const Storm storm{options.speed, options.open ? 0.0 : options.spacing, options.seed};
    StormTree tree(job.species, job.tree, storm);
    tree.advance(settlingTime);
    VectorStatistics moment, push, tip, strain;
    std::vector<glm::dvec2> strains;
    const auto rows = static_cast<std::size_t>(std::llround(options.duration / options.step));
    for (std::size_t row = 1; row <= rows; ++row) {
        const double time = options.step * static_cast<double>(row);
        const StormState now = tree.advance(settlingTime + time);
        moment.add(now.moment);
        push.add(now.push);
        tip.add(glm::dvec2(now.tip));
        strains.push_back(now.strain);
        strain.add(now.strain);
        if (trace)
            writeRow(trace, time, now);
    }
    const double strainLimit = tree.strainLimit();
    const std::optional<FreeSway> free = pullAndRelease(job.species, job.tree);
    const CriticalSpeeds critical =
        options.critical ? criticalSpeedsOf(job.species, job.tree, storm) : CriticalSpeeds();
    return {
        {"species", job.species.name},
        {"dbh_cm", options.diameter},
        {"height_m", options.height},
        {"crown_width_m", options.crownWidth},
        {"spacing_m", options.open ? Json() : Json(options.spacing)},
        {"basal_area_m2ha", options.open ? Json() : Json(options.basalArea)},
        {"leaves", options.leaves},
        {"speed_ms", options.speed},
        {"moment", moment.json()},
        {"push", push.json()},
        {"tip", tip.json()},
        {"weight_factor", tree.weightFactor()},
        {"strain_max", strain.max()},
        {"strain_limit", strainLimit > 0.0 ? Json(strainLimit) : Json()},
        {"features", json(free ? swayFeatures(strains, 1.0 / options.step, free->frequency) : std::nullopt)},
        {"frequency_hz", free ? Json(free->frequency) : Json()},
        {"critical", {{"uproot", json(critical.uproot)}, {"break", json(critical.breaking)}}}};
}

void print(const Json& storm) {
    const auto printStatistics = [&](const char* name, const char* unit) {
        const Json& of = storm[name];
        std::printf("%-6s %9.4g %9.4g %9.4g %s\n", name, of["mean"].get<double>(), of["sd"].get<double>(),
                    of["max"].get<double>(), unit);
    };
    const auto printCritical = [&](const char* name) {
        const Json& speed = storm["critical"][name];
        if (speed.is_null())
            std::printf(" %9s", "-");
        else
            std::printf(" %9.3g", speed.get<double>());
    };
    std::printf("%s, %.4g cm, %.4g m, %s, %.4g m/s at the top\n", storm["species"].get<std::string>().c_str(),
                storm["dbh_cm"].get<double>(), storm["height_m"].get<double>(),
                storm["spacing_m"].is_null() ? "in the open" : "in a stand", storm["speed_ms"].get<double>());
    std::printf("            mean        sd       max\n");
    printStatistics("moment", "N m at the ground");
    printStatistics("push", "N m of it from the air, without the overhanging weight");
    printStatistics("tip", "m");
    std::printf("          uproot     break\ncritical");
    printCritical("uproot");
    printCritical("break");
    std::printf(" m/s at the top\n");
}

/// Says so if the stem would have broken.
void noteBreakage(const std::string& tree, const Json& storm) {
    const Json &largest = storm["strain_max"], &limit = storm["strain_limit"];
    if (limit.is_number() && largest > limit)
        std::cerr << tree << ": note: the largest strain of the stem, " << largest.get<double>()
                  << ", exceeds the strain at which it breaks, " << limit.get<double>() << '\n';
}

void storm(const StormOptions& options) {
    const StormJob job(options, speciesByName(options.species));
    std::optional<AtomicTable> trace;
    if (!options.output.empty()) {
        trace.emplace(options.output);
        std::fprintf(trace->file(), "time,wind_x,wind_y,strain_x,strain_y,tilt_x,tilt_y,tip_x,tip_y\n");
    }
    const Json object = measureStorm(job, trace ? trace->file() : nullptr);
    if (trace)
        trace->finish();
    noteBreakage(job.species.name, object);
    if (options.json)
        std::cout << textOf(object) << '\n';
    else
        print(object);
}

/// Columns of a table of storms, as JSON pointers. The column "/moment/max" is named "moment_max".
const char* const stormColumns[] = {"/species",
                                    "/dbh_cm",
                                    "/height_m",
                                    "/crown_width_m",
                                    "/spacing_m",
                                    "/basal_area_m2ha",
                                    "/leaves",
                                    "/speed_ms",
                                    "/moment/mean",
                                    "/moment/sd",
                                    "/moment/max",
                                    "/push/mean",
                                    "/push/sd",
                                    "/push/max",
                                    "/tip/mean",
                                    "/tip/sd",
                                    "/tip/max",
                                    "/weight_factor",
                                    "/strain_max",
                                    "/strain_limit",
                                    "/features/snr",
                                    "/features/f0_hz",
                                    "/features/damping",
                                    "/features/skewness",
                                    "/features/kurtosis",
                                    "/features/p999_over_sd",
                                    "/features/f0_share",
                                    "/features/along_over_across",
                                    "/frequency_hz",
                                    "/critical/uproot",
                                    "/critical/break"};

std::string headOfTable() {
    std::string head;
    for (const std::string column : stormColumns)
        head += (head.empty() ? "" : ",") + column.substr(1);
    std::replace(head.begin(), head.end(), '/', '_');
    return head + '\n';
}

std::string rowOfTable(const Json& storm) {
    std::string row;
    for (const char* const column : stormColumns) {
        const Json::json_pointer pointer(column);
        const Json value = storm.contains(pointer) ? storm[pointer] : Json();
        row += column == stormColumns[0] ? "" : ",";
        row += value.is_string() ? csvCell(value.get<std::string>()) : value.is_null() ? "" : value.dump();
    }
    return row + '\n';
}

/// Reads the spacing or the basal area, which replaces either of the options.
void readStand(const TreeTable& table, const CsvTable::Row& row, StormOptions& options) {
    double spacing = 0.0, basalArea = 0.0;
    table.read(row, "spacing_m", minSpacing, 1000.0, spacing);
    table.read(row, "basal_area_m2ha", 0.1, 1000.0, basalArea);
    if (spacing > 0.0 && basalArea > 0.0)
        table.fail(row, {BadInput, "expected spacing_m or basal_area_m2ha, found both"});
    if (spacing > 0.0 || basalArea > 0.0) {
        options.spacing = spacing;
        options.basalArea = basalArea;
    }
}

void stormTable(const StormOptions& defaults) {
    const TreeTable table = TreeTable::read(defaults.table);
    std::vector<StormJob> jobs;
    std::vector<std::string> ids;
    for (const CsvTable::Row& row : table.rows()) {
        StormOptions options = defaults;
        table.read(row, options);
        readStand(table, row, options);
        table.read(row, "speed_ms", 0.0, 80.0, options.speed);
        const Species species = table.species(row, options);
        try {
            jobs.emplace_back(options, species);
        } catch (const CommandError& error) {
            table.fail(row, error);
        }
        ids.push_back(table.hasIds() ? csvCell(table.id(row)) + ',' : "");
    }
    std::vector<Json> storms(jobs.size());
    ThreadPool::executor()(jobs.size(), [&](std::size_t i) { storms[i] = measureStorm(jobs[i], nullptr); });
    std::string text = (table.hasIds() ? "id," : "") + headOfTable();
    for (std::size_t i = 0; i < storms.size(); ++i) {
        noteBreakage(table.placeOf(table.rows()[i]), storms[i]);
        text += ids[i] + rowOfTable(storms[i]);
    }
    if (defaults.output.empty()) {
        std::cout << text;
        return;
    }
    writeOrThrow(defaults.output, text);
}

} // namespace

void addStormCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "storm", "Simulate one tree in a storm, in a stand or alone, and measure its sway");
    auto options = std::make_shared<StormOptions>();
    addTreeOptions(*command, *options);
    CLI::Option* const spacing =
        command
            ->add_option(
                "--spacing", options->spacing,
                "Distance between the trees of the stand, m (default: the crowns just cover the ground)")
            ->check(between(minSpacing, 1000.0))
            ->excludes("--open");
    command
        ->add_option("--basal-area", options->basalArea,
                     "In place of --spacing: cross-section of the stems at breast height per ground, m²/ha")
        ->check(between(0.1, 1000.0))
        ->excludes("--open")
        ->excludes(spacing);
    command
        ->add_option("--speed", options->speed,
                     "Mean wind at the top of the canopy (with --open: at the top of the tree), m/s")
        ->check(between(0.0, 80.0))
        ->capture_default_str();
    command->add_option("--duration", options->duration, "Measured time, s, after 60 s that are not measured")
        ->check(between(1.0, 1e6))
        ->capture_default_str();
    command->add_option("--step", options->step, "Time step of the trace, s")
        ->check(between(1e-3, 0.125))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "Seed of the gusts; the same seed gives the same wind")
        ->capture_default_str();
    command->add_option("-o,--output", options->output,
                        "CSV file for the trace of wind and sway; with --table, for the results");
    CLI::Option* const json = command->add_flag("--json", options->json, "Print the result as JSON");
    command->add_flag("!--no-critical", options->critical,
                      "Leave out the critical winds, which take most of the time");
    command
        ->add_option("--table", options->table,
                     "CSV file of trees to simulate, on all processors; prints a CSV table of the results")
        ->excludes(json);
    command->footer(
        "Columns of the trace: time (s), wind at the top (m/s), strain of the wood at the foot of the "
        "trunk,\n"
        "tilt of the trunk at half its height (sine), shift of its top (m); x along the mean wind, y "
        "across.\n"
        "Features describe the strain. They need 20 minutes or more, and a --step that divides 0.25 s.\n"
        "Critical winds are mean winds at the top, m/s, at which the largest moment in an hour (mean of "
        "three\n"
        "hours) reaches the strength of the roots (uproot) and of the stem (break).\n"
        "Columns of --table, all optional: species, dbh_cm, height_m, crown_width_m, open, leaves, "
        "spacing_m\n"
        "or basal_area_m2ha, speed_ms; the file of info --trees fits, too. Options fill in what the table "
        "leaves out.\n"
        "Example: osgtreewind storm --species \"Sitka spruce\" --dbh 24 --height 20 --speed 10 --json");
    command->callback([options] { options->table.empty() ? storm(*options) : stormTable(*options); });
}
