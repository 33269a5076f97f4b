// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/Progress.h>
#include <examples/osgtreewind/pictures/Drawing.h>
#include <examples/osgtreewind/pictures/TreeMap.h>
#include <examples/osgtreewind/storm/CriticalSpeeds.h>
#include <examples/osgtreewind/storm/ForestStorm.h>
#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/places/PointTable.h>
#include <osgTreeWind/system/Path.h>
#include <osgTreeWind/wind/WindDirection.h>

#include <glm/trigonometric.hpp>

#include <osgDB/FileNameUtils>

#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>

namespace {

using namespace osgTreeWind;

/// Simulated mean winds 10 m above open country, m/s: few trees fall in the first, few stand in the last.
constexpr double stormSpeeds[] = {12.0, 15.5, 20.0, 26.0, 34.0};

struct RiskOptions {
    std::string file, output, picture;
    std::optional<double> speed;
    double direction = 270.0;
    std::uint32_t seed = 1;
    std::optional<float> season;
    TileBox tiles;
};

/// Results of all storms, by slot.
struct Risk {
    std::vector<MomentsBySpeed> feet, boughs; ///< Moments at the foot; load over strength of boughs.
    std::vector<float> topWinds;
};

/// Simulates the storms for the first `count` trees of the forest.
Risk riskOf(const RiskOptions& options, const PlacedForest& forest, std::size_t count) {
    std::vector<double> speeds(std::begin(stormSpeeds), std::end(stormSpeeds));
    if (options.speed)
        speeds.push_back(*options.speed);
    const glm::vec3 toward = windVelocity({1.0, glm::radians(options.direction)}, DirectionSense::From);
    const ForestStorm storm(forest, toward, ThreadPool::executor(), count);
    Risk risk{std::vector<MomentsBySpeed>(count), std::vector<MomentsBySpeed>(count), storm.topWinds()};
    Progress progress("storms", speeds.size());
    for (const double speed : speeds) { // with the same gusts, so that moments grow with the wind
        const std::vector<ForestStorm::Loads> loads = storm.largestLoads(speed, options.seed);
        for (std::size_t slot = 0; slot < count; ++slot) {
            risk.feet[slot][speed] = loads[slot].foot;
            risk.boughs[slot][speed] = loads[slot].bough;
        }
        progress.advance();
    }
    return risk;
}

std::optional<double> share(double moment, double limit) {
    return limit > 0.0 ? std::optional(moment / limit) : std::nullopt;
}

PointTable tableOf(const RiskOptions& options, const PlacedForest& forest, const Risk& risk) {
    PointTable table;
    table.name = "risk";
    table.crs = forest.description().crs;
    table.texts = {"id", "species"};
    table.numbers = {"height_m", "dbh_cm", "crown_width_m", "uproot_ms", "break_ms", "bough_ms", "top_wind"};
    if (options.speed)
        table.numbers.insert(table.numbers.end(), {"uproot_ratio", "break_ratio", "bough_ratio"});
    for (std::size_t slot = 0; slot < risk.feet.size(); ++slot) {
        const PlacedTree& tree = forest.trees[slot];
        const TreePlacement placement = forest.placementOf(slot);
        const TreeSize size = forest.sizeOf(tree);
        const Species& species = forest.speciesOf(tree);
        const TreeStrength strength(forest.modelOf(tree), tree.scale, species);
        const CriticalSpeeds critical = criticalSpeeds(risk.feet[slot], strength);
        PointTable::Row row{placement.position,
                            {placement.name.empty() ? std::to_string(slot) : placement.name, species.name},
                            {size.height, 100.0 * static_cast<double>(size.trunkDiameter), size.crownWidth,
                             critical.uproot, critical.breaking, criticalSpeed(risk.boughs[slot], 1.0),
                             risk.topWinds[slot]}};
        if (options.speed) {
            const double moment = risk.feet[slot].at(*options.speed);
            row.numbers.push_back(share(moment, strength.uproot));
            row.numbers.push_back(share(moment, strength.breaking));
            const double bough = risk.boughs[slot].at(*options.speed);
            row.numbers.push_back(bough > 0.0 ? std::optional(bough) : std::nullopt);
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

bool writeCsv(const PointTable& table, const std::string& path) {
    std::ofstream output(toPath(path), std::ios::binary);
    output << "id,species,x,y";
    for (const std::string& column : table.numbers)
        output << ',' << column;
    output << '\n';
    char number[32];
    for (const PointTable::Row& row : table.rows) {
        output << csvCell(row.texts[0]) << ',' << csvCell(row.texts[1]);
        for (int axis = 0; axis < 2; ++axis) {
            std::snprintf(number, sizeof number, ",%.3f", row.position[axis]);
            output << number;
        }
        for (const std::optional<double>& value : row.numbers) {
            std::snprintf(number, sizeof number, value ? ",%.4g" : ",", value.value_or(0.0));
            output << number;
        }
        output << '\n';
    }
    return static_cast<bool>(output.flush());
}

void write(const PointTable& table, const std::string& output) {
    AtomicFile whole(output);
    Diagnostics problems;
    const bool written = osgDB::getLowerCaseFileExtension(output) == "gpkg"
                             ? (problems = writeGeoPackage(table, whole.writePath())).empty()
                             : writeCsv(table, whole.writePath());
    if (!written || !whole.commit())
        throwWriteError(whole, problems.empty() ? "" : problems.front().message);
    std::cout << table.rows.size() << " trees in " << output << '\n';
}

/// The forest from above, with the wind at which each tree falls.
void drawPicture(const RiskOptions& options, const PlacedForest& forest, const PointTable& table) {
    const auto columnOf = [&](const char* name) {
        return static_cast<std::size_t>(std::find(table.numbers.begin(), table.numbers.end(), name) -
                                        table.numbers.begin());
    };
    const std::size_t uprootColumn = columnOf("uproot_ms"), breakColumn = columnOf("break_ms");
    std::vector<MapTree> trees;
    for (std::size_t slot = 0; slot < table.rows.size(); ++slot) {
        const PointTable::Row& row = table.rows[slot];
        const std::optional<double>&uproot = row.numbers[uprootColumn], &breaking = row.numbers[breakColumn];
        const double width = static_cast<double>(forest.sizeOf(forest.trees[slot]).crownWidth);
        trees.push_back({glm::dvec2(row.position), 0.5 * width,
                         uproot && breaking ? std::min(*uproot, *breaking)
                         : uproot           ? uproot
                                            : breaking});
    }
    drawTreeMap(trees,
                osgDB::getSimpleFileName(options.file) + ": wind from " + numberText(options.direction) +
                    "° at which trees fall; circles are crowns",
                "m/s, mean of an hour 10 m above open country", options.picture);
}

void run(const RiskOptions& options) {
    const std::string extension = osgDB::getLowerCaseFileExtension(options.output);
    if (extension != "csv" && extension != "gpkg")
        throw CommandError{BadInput,
                           "--output: expected a name that ends in .csv or .gpkg, found " + options.output};
    checkOutputPath(options.output);
    if (!options.picture.empty())
        checkDrawingPath("--picture", options.picture);
    ForestPart part = loadPart(options.file, options.tiles);
    part.forest.season = options.season.value_or(part.forest.season);
    const PlacedForest forest(std::move(part.forest));
    const PointTable table = tableOf(options, forest, riskOf(options, forest, part.requested));
    write(table, options.output);
    if (!options.picture.empty())
        drawPicture(options, forest, table);
}

} // namespace

void addRiskCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "risk", "Compute the wind speeds at which each tree is uprooted, breaks or loses boughs");
    auto options = std::make_shared<RiskOptions>();
    command->add_option("file", options->file, "Forest or world to read (.treewind file)")->required();
    command->add_option("-o,--output", options->output, "Output file (.csv or .gpkg)")->required();
    command
        ->add_option("--speed", options->speed,
                     "Mean wind of a storm 10 m above open country, m/s: adds columns with load over "
                     "strength of each tree")
        ->check(between(1.0, 80.0));
    command
        ->add_option("--direction", options->direction,
                     "Direction that the wind comes from, degrees clockwise from north")
        ->check(between(-360.0, 360.0))
        ->capture_default_str();
    command->add_option("--seed", options->seed, "Seed of the gusts; the same seed gives the same wind")
        ->capture_default_str();
    command->add_option("--picture", options->picture,
                        "Also draw the trees from above, coloured by the wind at which they fall (.svg or "
                        ".png)");
    addSeasonOption(*command, options->season);
    addTilesOption(*command, options->tiles);
    command->footer(
        "Columns: id, species, x, y, height_m, dbh_cm, crown_width_m; uproot_ms, break_ms and bough_ms: mean "
        "wind 10 m\n"
        "above open country, m/s, at which the largest moment in an hour reaches the strength of the roots,\n"
        "of the stem and of the first bough; top_wind: mean wind at the top of the trees divided by the "
        "wind\n"
        "10 m above open country. A cell is empty if the value is unknown or above 80 m/s.\n"
        "Assumptions and limits: docs/risk.md.\n"
        "Example: osgtreewind risk forest.treewind -o risk.gpkg --speed 20 --direction 225");
    command->callback([options] { run(*options); });
}
