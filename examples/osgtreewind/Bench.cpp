// SPDX-License-Identifier: MIT
#include "BenchChart.h"
#include "BenchReport.h"
#include "BenchRun.h"
#include "Command.h"

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <osgDB/FileNameUtils>
#include <osgDB/ReadFile>
#include <osgDB/WriteFile>

#include <fstream>
#include <iostream>
#include <malloc.h>

namespace {

using namespace osgTreeWind;

struct BenchOptions {
    std::string output, chart, size = "1280x720", backend = offscreenBackendName();
    std::vector<std::string> stages;
    std::vector<int> trees = {1, 2, 3, 4, 16, 64};
    int frames = 60, forestTrees = 100000;
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

bool isAsked(const BenchOptions& options, const std::string& stage) {
    return options.stages.empty() ||
           std::find(options.stages.begin(), options.stages.end(), stage) != options.stages.end();
}

// Stages of their own, without frames.
const std::vector<std::string> kernelGroups = {"laws", "winds"};
const std::string forestsStage = "forests";

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
    if (isAsked(options, forestsStage) && !options.forest.empty() && !(forest = loadForest(options.forest)))
        return BadInput;
    for (const std::string& path : {options.output, options.chart})
        if (!path.empty() && !writeText(path, "")) // before minutes of measuring
            return Failed;

    keepMemory();
    BenchConditions conditions = benchConditions(settings);
    std::vector<BenchResult> results;
    for (const BenchStage& stage : benchStages()) {
        if (!isAsked(options, stage.name))
            continue;
        for (const int trees : options.trees) {
            Result<BenchResult> result = runBench(stage, trees, settings, conditions.driver);
            if (!result) {
                std::cerr << result.problems().front().text() << '\n';
                return Failed;
            }
            if (results.empty())
                printBenchHead(std::cout, conditions);
            printBenchRow(std::cout, result.value());
            results.push_back(std::move(result.value()));
        }
    }
    std::vector<std::string> groups;
    std::copy_if(kernelGroups.begin(), kernelGroups.end(), std::back_inserter(groups),
                 [&](const std::string& group) { return isAsked(options, group); });
    const std::vector<BenchKernel> kernels = runBenchKernels(groups, options.frames);
    if (!kernels.empty())
        printBenchKernels(std::cout, conditions, kernels);
    std::optional<BenchForests> forests;
    if (isAsked(options, forestsStage)) {
        forests = runBenchForests(forest, options.forest, static_cast<std::size_t>(options.forestTrees),
                                  options.frames);
        printBenchForests(std::cout, conditions, *forests);
    }

    if (!options.output.empty() &&
        !writeText(options.output, benchReport(conditions, results, kernels, forests).dump(2) + '\n'))
        return Failed;
    if (!options.chart.empty() && !writeChart(options.chart, benchChart(conditions, results)))
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
    names.insert(names.end(), kernelGroups.begin(), kernelGroups.end());
    names.push_back(forestsStage);
    command->add_option("--stage", options->stages, "Stages to measure; all when not given")
        ->delimiter(',')
        ->check(CLI::IsMember(names));
    command->add_option("--trees", options->trees, "Numbers of reference trees")
        ->delimiter(',')
        ->check(CLI::Range(1, 1024))
        ->capture_default_str();
    command
        ->add_option("--frames", options->frames,
                     "Pairs of frames, one in motion and one at rest; rounds of laws, winds and forests")
        ->check(CLI::Range(1, 100000))
        ->capture_default_str();
    command
        ->add_option("--forest", options->forest,
                     "Stage forests: a .treewind file to step under damped; made trees when not given")
        ->type_name("FILE");
    command->add_option("--forest-trees", options->forestTrees, "Stage forests: trees under modal")
        ->check(CLI::Range(1, 1000000))
        ->capture_default_str();
    command->add_option("--size", options->size, "Width and height in pixels")->capture_default_str();
    command->add_option("-o,--output", options->output, "JSON file for the results (docs/results.md)");
    command->add_option("--chart", options->chart, "SVG file for a chart; a PNG is put beside it");
    command->add_option("--backend", options->backend, "Where OpenGL comes from")
        ->check(CLI::IsMember({"osmesa", "egl"}))
        ->capture_default_str();
    command->footer("fps = frames / seconds; times in milliseconds.\n"
                    "Every stage is drawn in turns with the same trees at rest (static), so that what else\n"
                    "the machine does falls on both; ratios are medians of such pairs.\n"
                    "Example: osgtreewind bench --trees 1,4 --stage gpu,gpu-leaves -o results.json\n"
                    "         osgtreewind bench --stage laws,forests --forest campus.treewind");
    command->callback([options, &exitCode] { exitCode = bench(*options); });
}
