// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchReport.h>
#include <examples/osgtreewind/bench/BenchRun.h>
#include <examples/osgtreewind/options/Command.h>
#include <examples/osgtreewind/pictures/WritePicture.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>

#include <fstream>
#include <iostream>
#include <malloc.h>

namespace {

using namespace osgTreeWind;

constexpr std::size_t mostTreesInFull = 20000; // memory and minutes grow with each of them

struct BenchOptions {
    std::string output, chart, size = "1280x720", backend = offscreenBackendName();
    std::vector<std::string> stages;
    std::vector<int> trees = {1, 2, 3, 4, 16, 64}, scaleTrees = {1000, 10000, 100000};
    int frames = 60;
    std::string forest;
};

/// Keeps freed memory: page faults of the driver's buffers would be measured otherwise.
void keepMemory() {
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
    mallopt(M_MMAP_THRESHOLD, 32 << 20);
}

/// The SVG, and a PNG of it beside.
void writeChart(const std::string& path, const std::string& svg) {
    writeOrEnd(path, svg);
    const std::string picture = osgDB::getNameLessExtension(path) + ".png";
    const osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(path);
    if (!image)
        throw Ending{Failed, picture + ": cannot be written; expected the svg plugin of OpenSceneGraph"};
    writePicture(*image, picture);
}

// Stages of their own.
const std::string scaleStage = "scale", viewStage = "view", worldStage = "world";

/// All but the view of a file and a flight, or that view only where a file is given.
bool isAsked(const BenchOptions& options, const std::string& stage) {
    if (options.stages.empty())
        return stage != worldStage && (stage == viewStage) != options.forest.empty();
    return std::find(options.stages.begin(), options.stages.end(), stage) != options.stages.end();
}

/// Of the forest in a file.
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

/// All that is asked for, said on standard output as it comes.
void measure(const BenchOptions& options, const ForestDescription& forest, BenchConditions& conditions,
             BenchReport& report) {
    for (const BenchStage& stage : benchStages()) {
        if (!isAsked(options, stage.name))
            continue;
        for (const int trees : options.trees) {
            BenchResult result = runBench(stage, trees, conditions.settings, conditions.driver);
            if (report.results.empty())
                printBenchHead(std::cout, conditions);
            printBenchRow(std::cout, result);
            report.results.push_back(std::move(result));
        }
    }
    if (isAsked(options, scaleStage)) {
        report.scale = runBenchScale(options.scaleTrees, conditions.settings, conditions.driver);
        printBenchViews(std::cout, conditions, report.scale);
    }
    if (isAsked(options, viewStage)) {
        report.views = runBenchViews(options, forest, conditions.settings, conditions.driver);
        printBenchViews(std::cout, conditions, report.views);
    }
    if (isAsked(options, worldStage)) {
        report.world = runBenchWorld(options.forest, forest, conditions.settings, conditions.driver);
        printBenchWorld(std::cout, conditions, *report.world);
    }
}

/// Of the file, as the stages need it; empty where they need none.
ForestDescription load(const BenchOptions& options) {
    const bool drawn = isAsked(options, viewStage), flown = isAsked(options, worldStage);
    if ((drawn || flown) && options.forest.empty())
        throw Ending{BadInput, "--stage " + (drawn ? viewStage : worldStage) + ": expected --forest FILE"};
    if (!flown)
        return drawn ? loadForest(options.forest, {}, true) : ForestDescription();
    ForestDescription world = valueOf(readForestFile(options.forest));
    if (!world.tiles || options.stages.size() > 1)
        throw Ending{BadInput,
                     "--stage world: expected it alone, with a --forest in tiles (osgtreewind tile)"};
    return world;
}

void bench(const BenchOptions& options) {
    BenchSettings settings;
    settings.size = parsePictureSize(options.size, maxOffscreenSize);
    settings.frames = options.frames;
    if (options.backend != offscreenBackendName())
        runOtherBackend(options.backend);
    if (!options.chart.empty() && osgDB::getLowerCaseFileExtension(options.chart) != "svg")
        throw Ending{BadInput, "--chart: expected a name that ends in .svg, found " + options.chart};
    const ForestDescription forest = load(options);
    for (const std::string& path : {options.output, options.chart})
        if (!path.empty()) // before minutes of measuring
            if (const WholeFile whole(path); !std::ofstream(whole.unfinished()))
                endUnwritten(whole);

    keepMemory();
    BenchConditions conditions = benchConditions(settings);
    BenchReport report;
    measure(options, forest, conditions, report);
    if (!options.output.empty())
        writeOrEnd(options.output, benchReport(conditions, report).dump(2) + '\n');
    if (!options.chart.empty())
        writeChart(options.chart, benchChart(conditions, report.results));
}

} // namespace

void addBenchCommand(CLI::App& app) {
    CLI::App* command =
        app.add_subcommand("bench", "Measure the stages of the thesis' chapter 6, and beyond");
    auto options = std::make_shared<BenchOptions>();
    std::vector<std::string> names;
    for (const BenchStage& stage : benchStages())
        names.push_back(stage.name);
    names.insert(names.end(), {scaleStage, viewStage, worldStage});
    command
        ->add_option("--stage", options->stages, "Stages to measure; all but view and world when not given")
        ->delimiter(',')
        ->check(CLI::IsMember(names));
    command->add_option("--trees", options->trees, "Numbers of reference trees")
        ->delimiter(',')
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command->add_option("--frames", options->frames, "Pairs of frames, one in motion and one at rest")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command
        ->add_option("--forest", options->forest,
                     "A .treewind file: drawn by stage view, the only one then when none is given;\n"
                     "flown through by stage world")
        ->type_name("FILE");
    command
        ->add_option("--scale-trees", options->scaleTrees, "Stage scale: trees of the woods that are drawn")
        ->delimiter(',')
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
    command->add_option("-o,--output", options->output, "JSON file for the results (docs/results.md)");
    command->add_option("--chart", options->chart, "SVG file for a chart; a PNG is put beside it");
    addBackendOption(*command, options->backend);
    command->footer("fps = frames / seconds; times in milliseconds.\n"
                    "Every stage is drawn in turns with the same trees at rest (static), so that what else\n"
                    "the machine does falls on both; ratios are medians of such pairs.\n"
                    "Example: osgtreewind bench --trees 1,4 --stage gpu,gpu-leaves -o results.json\n"
                    "         osgtreewind bench --forest campus.treewind");
    command->callback([options] { bench(*options); });
}
