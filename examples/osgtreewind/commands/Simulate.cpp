// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/AtomicTable.h>
#include <examples/osgtreewind/output/Progress.h>
#include <examples/osgtreewind/output/Signals.h>
#include <examples/osgtreewind/pictures/Drawing.h>
#include <examples/osgtreewind/simulate/MotionFile.h>
#include <examples/osgtreewind/simulate/MotionPlot.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>

#include <osgDB/FileNameUtils>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <functional>
#include <memory>

namespace {

using namespace osgTreeWind;

struct SimulateOptions {
    std::string file, output = "-", plot;
    std::vector<std::string> trees;
    std::vector<std::size_t> units;
    double duration = 10.0, fps = 60.0;
    std::size_t every = 1;
    bool tips = false, tops = false, loads = false, damage = false;
    std::optional<float> season;
    TileBox tiles;
};

/// The trees of --trees among the requested ones: by id or, where no tree has that id, by number.
std::vector<TreeId> treesOf(const SimulateOptions& options, const ForestSimulation& simulation,
                            std::size_t requested) {
    std::vector<TreeId> all = simulation.trees();
    all.resize(requested);
    if (options.trees.empty())
        return all;
    std::vector<TreeId> trees;
    for (const std::string& word : options.trees) {
        std::size_t number = requested;
        bool isNumber = true;
        if (const std::optional<TreeId> named = simulation.findTree(word))
            number = slotOfTree(*named);
        else
            isNumber = std::from_chars(word.data(), word.data() + word.size(), number).ptr ==
                       word.data() + word.size();
        if (!isNumber || number >= requested)
            throw CommandError{BadInput, "--trees: expected the id of a tree in " + options.file +
                                             " or a number below " + std::to_string(requested) + ", found " +
                                             word};
        if (std::find(trees.begin(), trees.end(), all[number]) == trees.end())
            trees.push_back(all[number]);
    }
    return trees;
}

MotionTable tableOf(const SimulateOptions& options, const ForestSimulation& simulation,
                    const std::vector<TreeId>& trees) {
    if (options.tops)
        return topTable(simulation, trees);
    if (!options.loads)
        return branchTable(simulation, trees, options.tips);
    return options.units.empty() ? loadTable(trees) : unitLoadTable(simulation, trees, options.units);
}

bool isNetCdf(const SimulateOptions& options) {
    return osgDB::getLowerCaseFileExtension(options.output) == "nc";
}

const char* wordOf(DamageKind kind) {
    switch (kind) {
    case DamageKind::Uprooted:
        return "uprooted";
    case DamageKind::Snapped:
        return "snapped";
    case DamageKind::BoughTorn:
        break;
    }
    return "bough";
}

void writeDamage(std::FILE* out, const ForestSimulation& simulation, const std::vector<TreeId>& trees,
                 double time) {
    for (const TreeDamage& damage : simulation.damage()) {
        if (std::find(trees.begin(), trees.end(), damage.tree) == trees.end())
            continue;
        const std::size_t slot = slotOfTree(damage.tree);
        const PlacedForest& forest = movingForest(simulation).placed();
        const std::string id = csvCell(simulation.nameOf(damage.tree));
        std::fprintf(out, "%.6g,%zu,%s,%s,%s,%u,%.6g,%.6g,%.6g,%.6g,%.6g,%s\n", time, slot, id.c_str(),
                     csvCell(forest.speciesOf(forest.trees[slot]).name).c_str(), wordOf(damage.kind),
                     damage.unit, static_cast<double>(damage.moment), static_cast<double>(damage.limit),
                     static_cast<double>(damage.wind.x), static_cast<double>(damage.wind.y),
                     static_cast<double>(damage.wind.z), id.c_str());
    }
}

std::size_t stepsOf(const SimulateOptions& options) {
    return static_cast<std::size_t>(std::llround(options.duration * options.fps)) + 1;
}

/// Advances the simulation step by step. @param use called after each step.
void run(const SimulateOptions& options, ForestSimulation& simulation,
         const std::function<void(std::size_t step, double time)>& use) {
    const std::size_t steps = stepsOf(options);
    Progress progress("simulate", steps);
    for (std::size_t step = 0; step < steps; ++step) {
        const double time = static_cast<double>(step) / options.fps;
        simulation.advance(time);
        use(step, time);
        progress.advance();
    }
}

void simulateDamage(const SimulateOptions& options, ForestSimulation& simulation,
                    const std::vector<TreeId>& trees) {
    AtomicTable table(options.output);
    std::fputs("time,tree,name,species,kind,unit,moment,limit,wind_x,wind_y,wind_z,id\n", table.file());
    run(options, simulation, [&](std::size_t, double time) {
        const WholeRow rows;
        writeDamage(table.file(), simulation, trees, time);
        if (table.file() == stdout)
            std::fflush(stdout);
    });
    table.finish();
}

void simulateMotion(const SimulateOptions& options, ForestSimulation& simulation,
                    const std::vector<TreeId>& trees) {
    std::optional<MotionPlot> plot;
    if (!options.plot.empty() && trees.empty())
        throw CommandError{BadInput, "--plot: expected a tree in " + options.file + ", found none"};
    if (!options.plot.empty())
        plot.emplace(simulation, trees.front());
    const MotionTable table = tableOf(options, simulation, trees);
    if (options.tops || options.loads || plot) { // otherwise the jerk from rest would be the largest load
        simulation.advance(0.0);
        simulation.spinUp(trees);
    }
    std::unique_ptr<MotionFile> file;
    if (!options.output.empty())
        file = isNetCdf(options) ? createMotionNetCdf(options.output, table, simulation,
                                                      (stepsOf(options) - 1) / options.every + 1)
                                 : createMotionCsv(options.output, table, simulation);
    run(options, simulation, [&](std::size_t step, double time) {
        if (plot)
            plot->add(time);
        if (file && step % options.every == 0)
            file->write(time);
    });
    if (file)
        file->finish();
    if (plot)
        plot->write(options.plot);
}

void checkOptions(const SimulateOptions& options, const ForestDescription& forest) {
    for (const auto& [isGiven, name] : {std::pair(options.damage, "--damage"),
                                        {options.loads, "--loads"},
                                        {!options.plot.empty(), "--plot"}})
        if (isGiven && forest.law != MotionLaw::Modal)
            throw CommandError{BadInput,
                               options.file + ": " + name + " expects the law \"modal\" in [motion]"};
    if (options.damage && isNetCdf(options))
        throw CommandError{BadInput, "--output: --damage is written as CSV; expected another name than " +
                                         options.output};
    if (!options.plot.empty())
        checkDrawingPath("--plot", options.plot);
    if (isNetCdf(options))
        checkOutputPath(options.output);
}

void simulate(const SimulateOptions& options) {
    auto [description, requested] = loadPart(options.file, options.tiles);
    checkOptions(options, description);
    if (description.canopy.source != CanopySource::Forest)
        description.trees.resize(requested); // further trees only give shelter
    description.season = options.season.value_or(description.season);
    description.damage = description.damage || options.damage;
    auto growing = std::make_optional<Progress>("grow", description.trees.size());
    SimulationOptions simulationOptions;
    simulationOptions.leaves = false;
    simulationOptions.onTreePlaced = [&] { growing->advance(); };
    ForestSimulation simulation(std::move(description), simulationOptions);
    growing.reset();
    const std::vector<TreeId> trees = treesOf(options, simulation, requested);
    (options.damage ? simulateDamage : simulateMotion)(options, simulation, trees);
}

} // namespace

void addSimulateCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "simulate", "Compute the motion of branches, or the motion and loads of trees, and write a table");
    auto options = std::make_shared<SimulateOptions>();
    command->add_option("file", options->file, "Forest or world to read (.treewind file)")->required();
    command->add_option("--duration", options->duration, "Simulated time, s, from time 0")
        ->check(between(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--fps", options->fps, "Steps per second")
        ->check(between(1e-3, 1e5))
        ->capture_default_str();
    CLI::Option* output =
        command
            ->add_option("-o,--output", options->output,
                         "Output file: NetCDF if its name ends in .nc, else CSV; or - for standard output")
            ->capture_default_str();
    addSeasonOption(*command, options->season);
    addTilesOption(*command, options->tiles);
    command
        ->add_option("--trees", options->trees,
                     "Write only these trees: ids of the inventory, or numbers from 0")
        ->delimiter(',')
        ->allow_extra_args(false);
    CLI::Option* every =
        command->add_option("--every", options->every, "Write every Nth step, from the first one")
            ->check(CLI::Range(std::size_t(1), std::size_t(1000000000)));
    CLI::Option* tips =
        command->add_flag("--tips", options->tips, "Add the position of each branch tip in the scene, m");
    CLI::Option* tops =
        command->add_flag("--tops", options->tops, "Write the top of each tree instead of its branches")
            ->excludes(tips);
    CLI::Option* loads =
        command
            ->add_flag("--loads", options->loads,
                       "Write the sway of each tree and the moment at its foot instead (law modal)")
            ->excludes(tips)
            ->excludes(tops);
    command
        ->add_option(
            "--units", options->units,
            "With --loads: write the moment, strain and tilt at the base of these units of each tree "
            "instead, numbers from 0 (the foot)")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->needs(loads);
    CLI::Option* plot = command->add_option(
        "--plot", options->plot,
        "Picture (.svg or .png) of the first tree: the path of its top and the moment at its foot; without "
        "-o, no table is written (law modal)");
    CLI::Option* damage = command->add_flag("--damage", options->damage,
                                            "Write the trees and boughs that the wind brings down instead "
                                            "(turns on damage in [motion]; law modal)");
    for (CLI::Option* other : {tips, tops, loads, every, plot})
        damage->excludes(other);
    command->footer(
        "Columns: time (s), tree, unit, level, wind (m/s; x east, y north, z up), angle_a and angle_b\n"
        "(radians; angleXY and angleYZ of the thesis), with --tips tip (m). The last column of all tables "
        "is\n"
        "id, that of the inventory.\n"
        "Columns with --tops: time, tree; top now, rest (the top at rest), m in the scene.\n"
        "Columns with --loads: time, tree; wind at the top; shift (m) and velocity (m/s) of the top; lean\n"
        "(radians); moment at the foot (N m), and weight_moment, its part by the overhanging weight: x is\n"
        "positive if it turns the tree towards east, y towards north; limit: moment that fells the tree (N "
        "m);\n"
        "frequency (Hz). Cells of fallen trees are empty.\n"
        "Columns with --units: time, tree, unit; moment at the base (N m): x, y, z are positive if it turns\n"
        "the tip of the unit towards east, north, up; strain of the wood on the side away from that "
        "direction\n"
        "(positive: tension); tilt: direction of the unit minus that at rest; limit of a bough (N m). Loads\n"
        "are changes from rest. --tips --duration 0 shows where units are.\n"
        "With --tops, --loads and --plot trees already sway at time 0; otherwise they start at rest.\n"
        "Columns with --damage: time, tree, name, species, kind (uprooted, snapped or bough), unit (the "
        "tree\n"
        "or bough falls about its base), moment and limit at the foot of the tree or at the base of the "
        "bough\n"
        "(N m), wind in the crown (m/s).\n"
        "Examples: osgtreewind simulate thesis.treewind --duration 5 --fps 30 --tips -o motion.csv\n"
        "          osgtreewind simulate forest.treewind --loads --duration 600 --fps 10 -o loads.nc --plot "
        "tree.png");
    command->callback([options, output] {
        if (!options->plot.empty() && output->empty())
            options->output.clear();
        simulate(*options);
    });
}
