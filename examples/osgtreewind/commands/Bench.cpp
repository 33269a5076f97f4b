// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchReport.h>
#include <examples/osgtreewind/bench/BenchRun.h>
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/system/Memory.h>
#include <osgTreeWind/system/Path.h>

#include <fstream>
#include <iostream>

namespace {

using namespace osgTreeWind;

constexpr std::size_t mostTreesInFull = 20000; // limits memory and time

struct BenchOptions {
    std::string output, size = "1280x720", backend = offscreenBackendName();
    std::vector<std::string> stages;
    std::vector<int> trees = {1, 2, 3, 4, 16, 64}, scaleTrees = {1000, 10000, 100000};
    ContextProfile profile = osgProfile;
    int frames = 60;
    std::string forest;
};

// Stages that are not in benchStages().
const std::string scaleStage = "scale", viewStage = "view", worldStage = "world", callsStage = "calls";

/// Whether to run a stage. Default: all stages except view, world and calls, or only view if a forest is
/// given.
bool isRequested(const BenchOptions& options, const std::string& stage) {
    if (options.stages.empty())
        return stage != worldStage && stage != callsStage && (stage == viewStage) != options.forest.empty();
    return std::find(options.stages.begin(), options.stages.end(), stage) != options.stages.end();
}

/// Measures all views of the forest in a file.
std::vector<BenchView> runBenchViews(const BenchOptions& options, const ForestDescription& forest,
                                     const BenchSettings& settings, BenchDriver& driver) {
    std::vector<BenchView> views;
    for (const BenchViewpoint viewpoint :
         {BenchViewpoint::Over, BenchViewpoint::Home, BenchViewpoint::Inside})
        views.push_back(runBenchView(
            options.forest, [&] { return forest; }, viewpoint, forest.trees.size() <= mostTreesInFull,
            settings, driver));
    return views;
}

/// Runs all requested stages and prints each result as soon as it is measured.
void measure(const BenchOptions& options, const ForestDescription& forest, BenchConditions& conditions,
             BenchReport& report) {
    for (const BenchStage& stage : benchStages()) {
        if (!isRequested(options, stage.name))
            continue;
        for (const int trees : options.trees) {
            BenchResult result = runBench(stage, trees, conditions.settings, conditions.driver);
            if (report.results.empty())
                printBenchHead(std::cout, conditions);
            printBenchRow(std::cout, result);
            report.results.push_back(std::move(result));
        }
    }
    if (isRequested(options, scaleStage)) {
        report.scale = runBenchScale(options.scaleTrees, conditions.settings, conditions.driver);
        printBenchViews(std::cout, conditions, report.scale);
    }
    if (isRequested(options, viewStage)) {
        report.views = runBenchViews(options, forest, conditions.settings, conditions.driver);
        printBenchViews(std::cout, conditions, report.views);
    }
    if (isRequested(options, worldStage)) {
        report.world = runBenchWorld(options.forest, forest, conditions.settings, conditions.driver);
        printBenchWorld(std::cout, conditions, *report.world);
    }
    if (isRequested(options, callsStage)) {
        if (options.forest.empty())
            report.calls = runBenchCalls(conditions.settings, conditions.driver);
        else
            report.calls = {runBenchCalls(options.forest, forest, conditions.settings, conditions.driver)};
        printBenchCalls(std::cout, conditions, report.calls);
    }
}

/// The forest that the stages need; empty if they need none.
ForestDescription load(const BenchOptions& options) {
    const bool drawn = isRequested(options, viewStage), flown = isRequested(options, worldStage);
    if ((drawn || flown) && options.forest.empty())
        throw CommandError{BadInput,
                           "--stage " + (drawn ? viewStage : worldStage) + ": expected --forest FILE"};
    if (!flown)
        return options.forest.empty() ? ForestFile() : loadForest(options.forest, {}, true);
    ForestDescription world = valueOrThrow(readForestFile(options.forest));
    if (!world.tiles || options.stages.size() > 1)
        throw CommandError{
            BadInput,
            "--stage world: expected no other stage, and a --forest in tiles (made by osgtreewind tile)"};
    return world;
}

void bench(const BenchOptions& options) {
    BenchSettings settings;
    settings.size = parsePictureSize(options.size, maxOffscreenSize);
    settings.profile = options.profile;
    settings.frames = options.frames;
    if (options.backend != offscreenBackendName())
        runOtherBackend(options.backend);
    const ForestDescription forest = load(options);
    if (!options.output.empty()) // fail before minutes of measuring
        if (const AtomicFile whole(options.output); !std::ofstream(toPath(whole.writePath())))
            throwWriteError(whole);

    keepFreedMemory();
    BenchConditions conditions = benchConditions(settings);
    BenchReport report;
    measure(options, forest, conditions, report);
    if (!options.output.empty())
        writeOrThrow(options.output, textOf(benchReport(conditions, report)) + '\n');
}

} // namespace

void addBenchCommand(CLI::App& app) {
    CLI::App* command = app.add_subcommand(
        "bench", "Measure drawing speed: the stages of chapter 6 of the thesis, and larger forests");
    auto options = std::make_shared<BenchOptions>();
    std::vector<std::string> names;
    for (const BenchStage& stage : benchStages())
        names.push_back(stage.name);
    names.insert(names.end(), {scaleStage, viewStage, worldStage, callsStage});
    command
        ->add_option("--stage", options->stages,
                     "Stages to measure (default: all except view, world and calls)")
        ->delimiter(',')
        ->check(CLI::IsMember(names));
    command->add_option("--trees", options->trees, "Numbers of reference trees to measure")
        ->delimiter(',')
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command
        ->add_option("--frames", options->frames,
                     "Number of frame pairs, one frame in motion and one at rest")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command
        ->add_option("--forest", options->forest,
                     "Forest for the stages view, world and calls; without --stage only view is measured")
        ->type_name("FILE");
    command->add_option("--scale-trees", options->scaleTrees, "Numbers of trees for the stage scale")
        ->delimiter(',')
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--size", options->size, "Width and height of the picture, pixels")
        ->capture_default_str();
    command->add_option("-o,--output", options->output, "JSON file for the results (docs/results.md)");
    addBackendOption(*command, options->backend);
    addProfileOption(*command, options->profile);
    command->footer(
        "Times are in milliseconds; fps is frames divided by seconds. Frames of each stage alternate with\n"
        "frames of the same trees at rest (static), so other load on the machine affects both.\n"
        "Ratios are medians over these pairs.\n"
        "Examples:\n"
        "  osgtreewind bench --trees 1,4 --stage gpu,gpu-leaves -o results.json\n"
        "  osgtreewind bench --forest campus.treewind");
    command->callback([options] { bench(*options); });
}
