// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/output/AtomicTable.h>
#include <examples/osgtreewind/output/Progress.h>
#include <examples/osgtreewind/output/Signals.h>

#include <osgTreeWind/base/CsvCell.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/motion/damage/TreeDamage.h>

#include <glm/gtc/quaternion.hpp>

#include <cmath>
#include <cstdio>
#include <memory>

namespace {

using namespace osgTreeWind;

struct SimulateOptions {
    std::string file, output = "-";
    double duration = 10.0, fps = 60.0;
    bool tips = false, damage = false;
    std::optional<float> season;
    TileBox tiles;
};

/// Writes a row for each unit of the first `count` trees.
void writeFrame(std::FILE* out, const ForestSimulation& simulation, std::size_t count, double time,
                bool tips) {
    UnitValues values;
    for (std::size_t t = 0; t < count; ++t) {
        const PlacedTree& tree = movingForest(simulation).trees()[t];
        const std::vector<BranchUnit>& units = movingForest(simulation).models()[tree.model]->skeleton.units;
        const TreeMotion motion = movingForest(simulation).motion(t, values);
        const glm::quat heading = glm::angleAxis(tree.heading, glm::vec3(0, 0, 1));
        for (std::size_t u = 0; u < units.size(); ++u) {
            const glm::vec3& wind = motion.winds[u];
            const glm::vec4& state = motion.states[u];
            std::fprintf(out, "%.6g,%zu,%zu,%d,%.6g,%.6g,%.6g,%.6g,%.6g", time, t, u, units[u].level, wind.x,
                         wind.y, wind.z, state.x, state.y);
            if (tips) {
                const glm::vec3 tip =
                    tree.position + heading * motion.poses[u].apply(tree.scale.axes * units[u].tip);
                std::fprintf(out, ",%.6f,%.6f,%.6f", tip.x, tip.y, tip.z);
            }
            std::fputc('\n', out);
        }
    }
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

void writeDamage(std::FILE* out, const ForestSimulation& simulation, std::size_t count, double time) {
    for (const TreeDamage& damage : simulation.damage()) {
        if (slotOfTree(damage.tree) >= count)
            continue;
        const PlacedTree& tree = movingForest(simulation).trees()[slotOfTree(damage.tree)];
        std::fprintf(out, "%.6g,%zu,%s,%s,%s,%u,%.6g,%.6g,%.6g,%.6g,%.6g\n", time, slotOfTree(damage.tree),
                     csvCell(simulation.nameOf(damage.tree)).c_str(),
                     csvCell(movingForest(simulation).placed().speciesOf(tree).name).c_str(),
                     wordOf(damage.kind), damage.unit, static_cast<double>(damage.moment),
                     static_cast<double>(damage.limit), static_cast<double>(damage.wind.x),
                     static_cast<double>(damage.wind.y), static_cast<double>(damage.wind.z));
    }
}

void simulate(const SimulateOptions& options) {
    auto [description, requested] = loadPart(options.file, options.tiles);
    if (description.canopy.source != CanopySource::Forest)
        description.trees.resize(requested); // further trees only give shelter
    description.season = options.season.value_or(description.season);
    if (options.damage && description.law != MotionLaw::Modal)
        throw CommandError{BadInput, options.file + ": --damage expects the law \"modal\" in [motion]"};
    description.damage = description.damage || options.damage;
    auto growing = std::make_optional<Progress>("grow", description.trees.size());
    SimulationOptions simulationOptions;
    simulationOptions.leaves = false;
    simulationOptions.onTreePlaced = [&] { growing->advance(); };
    ForestSimulation simulation(std::move(description), simulationOptions);
    growing.reset();

    AtomicTable table(options.output);
    std::FILE* const out = table.file();
    if (options.damage)
        std::fputs("time,tree,name,species,kind,unit,moment,limit,wind_x,wind_y,wind_z\n", out);
    else
        std::fprintf(out, "time,tree,unit,level,wind_x,wind_y,wind_z,angle_a,angle_b%s\n",
                     options.tips ? ",tip_x,tip_y,tip_z" : "");
    const auto frames = static_cast<std::size_t>(std::llround(options.duration * options.fps)) + 1;
    Progress progress("simulate", frames);
    for (std::size_t frame = 0; frame < frames && !std::ferror(out); ++frame) {
        const double time = static_cast<double>(frame) / options.fps;
        simulation.advance(time);
        const WholeRow rows;
        if (options.damage)
            writeDamage(out, simulation, requested, time);
        else
            writeFrame(out, simulation, requested, time, options.tips);
        if (out == stdout)
            std::fflush(out);
        progress.advance();
    }
    table.finish();
}

} // namespace

void addSimulateCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("simulate", "Compute the motion of every branch and write it as CSV");
    auto options = std::make_shared<SimulateOptions>();
    command->add_option("file", options->file, "Forest or world to read (.treewind file)")->required();
    command->add_option("--duration", options->duration, "Simulated time, s, from time 0")
        ->check(between(0.0, 1e6))
        ->capture_default_str();
    command->add_option("--fps", options->fps, "Steps per second")
        ->check(between(1e-3, 1e5))
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "Output file (CSV), or - for standard output")
        ->capture_default_str();
    addSeasonOption(*command, options->season);
    addTilesOption(*command, options->tiles);
    command->add_flag("--tips", options->tips, "Add the position of each branch tip in the scene, m");
    command->add_flag("--damage", options->damage,
                      "Write the trees and boughs that the wind brings down instead (turns on damage in "
                      "[motion]; law modal)");
    command->footer(
        "Columns: time (s), tree, unit, level, wind (m/s; x east, y north, z up), angle_a and angle_b\n"
        "(radians; angleXY and angleYZ of the thesis).\n"
        "Columns with --damage: time (s), tree, name, species, kind (uprooted, snapped or bough), unit (the\n"
        "tree or bough falls about its base), moment and limit at the foot of the tree or at the base of "
        "the\n"
        "bough (N m), wind in the crown (m/s).\n"
        "Example: osgtreewind simulate thesis.treewind --duration 5 --fps 30 --tips -o motion.csv");
    command->callback([options] { simulate(*options); });
}
