// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchChart.h>
#include <examples/osgtreewind/bench/BenchReport.h>
#include <examples/osgtreewind/bench/BenchRun.h>
#include <examples/osgtreewind/bench/BenchWorld.h>
#include <examples/osgtreewind/options/Command.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

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

bool writeText(const std::string& path, const std::string& text) {
    std::ofstream file(path);
    file << text;
    file.close();
    if (!file)
        std::cerr << path << ": cannot be written\n";
    return !file.fail();
}

/// The SVG, and a PNG of it beside.
bool writeChart(const std::string& path, const std::string& svg) {
    if (!writeText(path, svg))
        return false;
    const std::string picture = osgDB::getNameLessExtension(path) + ".png";
    osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(path);
    if (image && osgDB::writeImageFile(*image, picture))
        return true;
    std::cerr << picture << ": cannot be written; expected the svg and png plugins of OpenSceneGraph\n";
    return false;
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
Result<std::vector<BenchView>> runBenchViews(const BenchOptions& options, const ForestDescription& forest,
                                             const BenchSettings& settings, BenchDriver& driver) {
    std::vector<BenchView> views;
    for (const BenchViewpoint viewpoint :
         {BenchViewpoint::Over, BenchViewpoint::Home, BenchViewpoint::Inside}) {
        Result<BenchView> view = runBenchView(
            options.forest, [&] { return forest; }, viewpoint, forest.trees.size() <= mostTreesInFull,
            settings, driver);
        if (!view)
            return view.problems();
        views.push_back(std::move(view.value()));
    }
    return views;
}

template <typename T>
bool succeeded(const Result<T>& result) {
    if (!result)
        std::cerr << result.problems().front().text() << '\n';
    return static_cast<bool>(result);
}

/// Of all numbers of trees. @return whether all went well.
bool runStages(const BenchOptions& options, BenchConditions& conditions, std::vector<BenchResult>& results) {
    for (const BenchStage& stage : benchStages()) {
        if (!isAsked(options, stage.name))
            continue;
        for (const int trees : options.trees) {
            Result<BenchResult> result = runBench(stage, trees, conditions.settings, conditions.driver);
            if (!succeeded(result))
                return false;
            if (results.empty())
                printBenchHead(std::cout, conditions);
            printBenchRow(std::cout, result.value());
            results.push_back(std::move(result.value()));
        }
    }
    return true;
}

/// All that is asked for, said on standard output as it comes. @return whether all went well.
bool measure(const BenchOptions& options, const std::optional<ForestDescription>& forest,
             BenchConditions& conditions, BenchReport& report) {
    if (!runStages(options, conditions, report.results))
        return false;
    if (isAsked(options, scaleStage)) {
        auto scale = runBenchScale(options.scaleTrees, conditions.settings, conditions.driver);
        if (!succeeded(scale))
            return false;
        report.scale = std::move(scale.value());
        printBenchViews(std::cout, conditions, report.scale);
    }
    if (isAsked(options, viewStage)) {
        auto views = runBenchViews(options, *forest, conditions.settings, conditions.driver);
        if (!succeeded(views))
            return false;
        report.views = std::move(views.value());
        printBenchViews(std::cout, conditions, report.views);
    }
    if (isAsked(options, worldStage)) {
        auto world = runBenchWorld(options.forest, *forest, conditions.settings, conditions.driver);
        if (!succeeded(world))
            return false;
        report.world = std::move(world.value());
        printBenchWorld(std::cout, conditions, *report.world);
    }
    return true;
}

/// Of the file, as the stages need it. @return whether all went well.
bool load(const BenchOptions& options, std::optional<ForestDescription>& forest) {
    const bool drawn = isAsked(options, viewStage), flown = isAsked(options, worldStage);
    if ((drawn || flown) && options.forest.empty()) {
        std::cerr << "--stage " << (drawn ? viewStage : worldStage) << ": expected --forest FILE\n";
        return false;
    }
    if (flown) {
        Result<ForestDescription> world = readForestFile(options.forest);
        if (!succeeded(world))
            return false;
        if (!world.value().tiles || options.stages.size() > 1) {
            std::cerr << "--stage world: expected it alone, with a --forest in tiles (osgtreewind tile)\n";
            return false;
        }
        forest = std::move(world.value());
    } else if (drawn) {
        forest = loadForest(options.forest, {}, true);
        return forest.has_value();
    }
    return true;
}

ExitCode bench(const BenchOptions& options) {
    BenchSettings settings;
    settings.size = parsePictureSize(options.size, maxOffscreenSize);
    settings.frames = options.frames;
    if (options.backend != offscreenBackendName())
        return runOtherBackend(options.backend);
    if (!options.chart.empty() && osgDB::getLowerCaseFileExtension(options.chart) != "svg") {
        std::cerr << "--chart: expected a name that ends in .svg, found " << options.chart << '\n';
        return BadInput;
    }
    std::optional<ForestDescription> forest;
    if (!load(options, forest))
        return BadInput;
    for (const std::string& path : {options.output, options.chart})
        if (!path.empty() && !writeText(path, "")) // before minutes of measuring
            return Failed;

    keepMemory();
    BenchConditions conditions = benchConditions(settings);
    BenchReport report;
    if (!measure(options, forest, conditions, report))
        return Failed;
    if (!options.output.empty() && !writeText(options.output, benchReport(conditions, report).dump(2) + '\n'))
        return Failed;
    if (!options.chart.empty() && !writeChart(options.chart, benchChart(conditions, report.results)))
        return Failed;
    return Succeeded;
}

} // namespace

void addBenchCommand(CLI::App& app, ExitCode& exitCode) {
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
    command->callback([options, &exitCode] { exitCode = bench(*options); });
}
