// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/canopy/CanopyFile.h>
#include <examples/osgtreewind/canopy/StandProfile.h>
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/AtomicTable.h>
#include <examples/osgtreewind/output/Json.h>
#include <examples/osgtreewind/output/Progress.h>

#include <osgTreeWind/base/AtomicFile.h>
#include <osgTreeWind/base/MemoryLimit.h>
#include <osgTreeWind/motion/MakeCanopyMap.h>

#include <osgDB/FileNameUtils>

#include <iostream>
#include <memory>
#include <sstream>

namespace {

using namespace osgTreeWind;

struct CanopyOptions {
    std::string file, output, format;
    std::vector<double> cell, bounds;
    std::optional<float> season;
    TileBox tiles;
    bool json = false, profile = false;
    std::string leaves;
    double leafArea = 0.0, dragCoefficient = 0.2, height = 20.0;
};

std::string formatOf(const CanopyOptions& options) {
    if (!options.format.empty())
        return options.format;
    const std::string extension = osgDB::getFileExtension(options.output);
    return extension == "nc" ? "palm" : extension == "vti" ? "vtk" : "";
}

Result<CanopyGrid> gridOf(const CanopyOptions& options, const PlacedForest& forest) {
    const std::vector<double>& cell = options.cell;
    std::optional<CanopyBounds> bounds;
    if (options.bounds.size() == 4)
        bounds = {{options.bounds[0], options.bounds[1]}, {options.bounds[2], options.bounds[3]}};
    return canopyGridOver(forest,
                          cell.size() == 3 ? glm::dvec3(cell[0], cell[1], cell[2]) : glm::dvec3(cell[0]),
                          formatOf(options) == "palm", bounds);
}

std::unique_ptr<CanopyFile> create(const std::string& path, const std::string& format,
                                   const CanopyHead& head) {
    return format == "vtk"  ? createVtkCanopy(path, head)
           : format == "cf" ? createCfCanopy(path, head)
                            : createPalmCanopy(path, head);
}

/// C of a canopy model with the force C lad U^2: half of CdA over the leaf area. Empty without leaves.
std::optional<double> coefficientOf(const AreaSums& sums) {
    return sums.leaf > 0.0 ? std::optional(0.5 * sums.drag / sums.leaf) : std::nullopt;
}

Json toJson(const AreaSums& sums) {
    return {{"leafArea", sums.leaf}, {"dragArea", sums.drag}};
}

Json toJson(const CanopyGrid& grid, const CanopyTally& tally) {
    const auto coefficient = coefficientOf(tally.within);
    Json json = {{"trees", tally.trees},
                 {"leafArea", tally.within.leaf},
                 {"dragArea", tally.within.drag},
                 {"dragCoefficient", coefficient ? Json(*coefficient) : Json()},
                 {"beyond", toJson(tally.beyond)},
                 {"heights", grid.aboveGround ? "above the ground" : "of the world"}};
    for (int axis = 0; axis < 3; ++axis) {
        json["low"].push_back(grid.low[axis]);
        json["cell"].push_back(grid.cell[axis]);
        json["cells"].push_back(grid.cells[axis]);
    }
    return json;
}

void print(const CanopyGrid& grid, const CanopyTally& tally) {
    std::ostringstream text;
    text << "trees        " << tally.trees << "\nleaf area    " << tally.within.leaf << " m2\ndrag area    "
         << tally.within.drag << " m2 (CdA)\n";
    if (const auto coefficient = coefficientOf(tally.within))
        text << "coefficient  " << *coefficient << " (C of the force C lad U^2, half of CdA / leaf area)\n";
    text << "cells        " << grid.cells.x << " x " << grid.cells.y << " x " << grid.cells.z << ", of "
         << grid.cell.x << " x " << grid.cell.y << " x " << grid.cell.z << " m\n";
    text.precision(12);
    text << "corner       " << grid.low.x << ", " << grid.low.y << ", " << grid.low.z
         << (grid.aboveGround ? " above the ground\n" : "\n");
    std::cout << text.str();
}

void printWarnings(const CanopyOptions& options, const ForestDescription& forest, const CanopyTally& tally) {
    const double all = tally.within.drag + tally.beyond.drag;
    if (tally.beyond.drag > 1e-9 * all)
        std::cerr << options.file << ": note: " << 100.0 * tally.beyond.drag / all
                  << " % of the trees' drag area is outside --bounds\n";
    if (formatOf(options) == "palm" && forest.crs.empty())
        std::cerr << options.file << ": note: the forest has no crs, so origin_lat and origin_lon are 0 and "
                  << options.output << " has no variable crs\n";
}

/// Writes the file and prints a summary of it.
void writeCanopy(const CanopyOptions& options, const PlacedForest& forest, const CanopyGrid& grid) {
    AtomicFile whole(options.output);
    const auto file =
        create(whole.writePath(), formatOf(options), {grid, forest.description().crs, forest.season()});
    Progress progress("canopy", static_cast<std::size_t>(grid.cells.y));
    const CanopyTally tally = spreadCanopy(forest, grid, [&](const CanopyRow& row) {
        progress.advance();
        return file->write(row);
    });
    if (!tally.finished || !file->close() || !whole.commit())
        throwWriteError(whole, file->problem());
    printWarnings(options, forest.description(), tally);
    if (options.json)
        std::cout << textOf(toJson(grid, tally)) << '\n';
    else
        print(grid, tally);
}

/// Levels of a profile in each layer of a forest, and in a given stand.
constexpr std::size_t levelsPerLayer = 8, levelsOfStand = 64;

StandLeaves givenStand(const CanopyOptions& options) {
    StandLeaves leaves;
    leaves.height = static_cast<float>(options.height);
    leaves.drag = valueOrThrow(readLeafShares(options.leaves, levelsOfStand));
    for (float& layer : leaves.drag)
        layer *= static_cast<float>(options.leafArea * options.dragCoefficient);
    return leaves;
}

StandLeaves standOf(const CanopyOptions& options, const PlacedForest& forest) {
    std::vector<CanopyTree> trees;
    for (const PlacedTree& tree : forest.trees)
        trees.emplace_back(forest, tree);
    StandLeaves leaves = meanStandOf(trees);
    if (leaves.drag.empty())
        throw CommandError{BadInput, options.file + ": expected trees for --profile, found none"};
    return leaves;
}

void writeProfile(const StandLeaves& leaves, std::size_t steps, const std::string& output) {
    AtomicTable table(output);
    writeStandProfile(solveStandFlow(leaves.drag, steps), static_cast<double>(leaves.height), table.file());
    table.finish();
}

void run(const CanopyOptions& options) {
    if (!options.leaves.empty())
        return writeProfile(givenStand(options), 1, options.output);
    if (!options.profile && formatOf(options).empty())
        throw CommandError{BadInput,
                           "--output: expected a name that ends in .nc or .vti, or a --format, found " +
                               options.output};
    checkOutputPath(options.output);
    ForestDescription description = loadForest(options.file, options.tiles);
    description.season = options.season.value_or(description.season);
    const PlacedForest forest(std::move(description));
    if (options.profile)
        return writeProfile(standOf(options, forest), levelsPerLayer, options.output);
    const Result<CanopyGrid> grid = gridOf(options, forest);
    const std::string problem =
        grid ? problemOfMemory("--cell: cells of this size", canopyBytes(forest, grid.value()))
             : "--" + grid.problems().front().text();
    if (!problem.empty())
        throw CommandError{BadInput, options.file + ": " + problem};
    writeCanopy(options, forest, grid.value());
}

} // namespace

void addCanopyCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("canopy", "Write leaf area and drag area on a grid for flow models (CFD)");
    auto options = std::make_shared<CanopyOptions>();
    CLI::Option* file =
        command->add_option("file", options->file, "Forest or world to read (.treewind file)");
    command->add_option("-o,--output", options->output, "Output file (.nc or .vti; with --profile CSV)")
        ->required();
    CLI::Option* cell =
        command
            ->add_option("--cell", options->cell, "Size of a cell, m: DX,DY,DZ, or one number for all sides")
            ->delimiter(',')
            ->check(between(0.01, 1e6))
            ->expected(1, 3)
            ->allow_extra_args(false);
    command
        ->add_option("--bounds", options->bounds,
                     "Area of the grid on the map: X0,Y0,X1,Y1, a whole number of cells (default: all trees)")
        ->delimiter(',')
        ->check(between(-1e9, 1e9))
        ->expected(4)
        ->allow_extra_args(false);
    command
        ->add_option("--format", options->format,
                     "Format: palm (PALM static driver, .nc), cf (CF NetCDF, .nc) or vtk (.vti); default: "
                     "palm or vtk by the file ending")
        ->check(CLI::IsMember({"palm", "cf", "vtk"}));
    addSeasonOption(*command, options->season);
    addTilesOption(*command, options->tiles);
    command->add_flag("--json", options->json, "Print the result as JSON");
    CLI::Option* profile = command->add_flag(
        "--profile", options->profile,
        "Write mean wind, shear stress and turbulence by height in the mean stand of the forest as CSV");
    CLI::Option* leaves =
        command
            ->add_option(
                "--leaves", options->leaves,
                "With --profile, in place of a forest: CSV file with the columns z_over_h and leaf_area "
                "(relative leaf area density from the row before, or the ground, up to z)")
            ->needs(profile)
            ->excludes(file);
    command->add_option("--lai", options->leafArea, "Leaf area index of --leaves, m2/m2")
        ->check(between(0.0, 100.0))
        ->needs(leaves);
    command->add_option("--cd", options->dragCoefficient, "Coefficient C of --leaves, of the force C lad U^2")
        ->check(between(0.0, 10.0))
        ->needs(leaves)
        ->capture_default_str();
    command->add_option("--height", options->height, "Height of the stand of --leaves, m")
        ->check(between(0.1, 150.0))
        ->needs(leaves)
        ->capture_default_str();
    command->footer(
        "Arrays: lad (leaf area density, m2/m3) and cda (drag area density, m2/m3). Heights count from\n"
        "the ground in palm, and from the zero of the map in cf and vtk. See docs/cfd.md.\n"
        "Columns of --profile: z_over_h; z_m, m; u_over_uh, mean wind over that at the top; "
        "stress_over_ustar2,\n"
        "shear stress over that at the top, u*^2; sigma_{u,v,w}_over_ustar, standard deviations along, "
        "across, up.\n"
        "Examples: osgtreewind canopy forest.treewind -o canopy.nc --cell 2,2,1 --season summer\n"
        "          osgtreewind canopy --profile --leaves leaves.csv --lai 4.9 --cd 0.15 -o profile.csv");
    command->callback([options, file, cell, profile, leaves] {
        if (file->empty() && leaves->empty())
            throw CommandError{BadInput,
                               profile->empty() ? "file is required" : "a file or --leaves is required"};
        if (cell->empty() == profile->empty())
            throw CommandError{BadInput, cell->empty() ? "--cell is required" : "--cell excludes --profile"};
        if (!leaves->empty() && !(options->leafArea > 0.0))
            throw CommandError{BadInput, "--leaves: expected a --lai above 0"};
        if (options->cell.size() == 2)
            throw CommandError{BadInput, "--cell: expected DX or DX,DY,DZ, found two numbers"};
        run(*options);
    });
}
