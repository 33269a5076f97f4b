// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchReport.h>

#include <examples/osgtreewind/bench/BenchWorld.h>

#include <examples/osgtreewind/bench/BenchStatistics.h>

#include <osgTreeWind/offscreen/OffscreenContext.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>
#include <sys/utsname.h>
#include <thread>

namespace {

Json number(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json spread(const std::vector<double>& values) {
    return {{"median", number(quantile(values, 0.5))},
            {"p10", number(quantile(values, 0.1))},
            {"p90", number(quantile(values, 0.9))}};
}

Json timesJson(const BenchTimes& times) {
    return {{"seconds", std::accumulate(times.frame.begin(), times.frame.end(), 0.0) / 1000.0},
            {"fps", number(framesPerSecond(times))},
            {"frameMs", spread(times.frame)},
            {"processorMs", spread(times.processor)},
            {"updateMs", spread(times.update)},
            {"cullMs", spread(times.cull)},
            {"drawMs", spread(times.draw)},
            {"gpuMs", spread(times.gpu)}};
}

Json forestJson(const BenchForest& forest) {
    return {{"forest", forest.name},
            {"threads", forest.threads},
            {"trees", forest.trees},
            {"nearTrees", forest.nearTrees},
            {"units", forest.units},
            {"loadSeconds", number(forest.loadSeconds)},
            {"loadProcessorSeconds", number(forest.loadProcessorSeconds)},
            {"archetypes", forest.archetypes},
            {"archetypeBytes", forest.archetypeBytes},
            {"stateBytesPerTree", number(forest.stateBytesPerTree)},
            {"stepMs", spread(forest.stepMs)},
            {"oneCoreStepMs", spread(forest.oneCoreStepMs)}};
}

Json resultJson(const BenchResult& result) {
    const BenchCounts& counts = result.counts;
    const int thesis = thesisFps(result.stage, result.trees);
    Json json = {{"stage", result.stage.name},
                 {"title", result.stage.title},
                 {"trees", result.trees},
                 {"frames", result.moving.frame.size()},
                 {"law", result.stage.law() == osgTreeWind::MotionLaw::Thesis ? "thesis" : "modal"},
                 {"angles", result.angles}};
    json["moving"] = timesJson(result.moving);
    json["static"] = timesJson(result.still);
    json["ratioToStatic"] = spread(ratios(result.moving.frame, result.still.frame));
    json["processorRatioToStatic"] = spread(ratios(result.moving.processor, result.still.processor));
    json["counts"] = {{"units", counts.units},         {"vertices", counts.vertices},
                      {"triangles", counts.triangles}, {"lines", counts.lines},
                      {"nodes", counts.nodes},         {"transforms", counts.transforms},
                      {"drawables", counts.drawables}};
    json["thesisTable"] = result.stage.table.empty() ? Json(nullptr) : Json(result.stage.table);
    json["thesisFps"] = thesis > 0 ? Json(thesis) : Json(nullptr);
    return json;
}

/// Of a forest's frames over those of the tree drawn in the same rounds.
std::vector<double> inFullRatios(const BenchView& view) {
    std::vector<double> trees;
    for (std::size_t i = 0; i < view.inFull.frame.size(); ++i)
        trees.push_back(view.tree.frame[i * BenchView::roundsPerFull]);
    return ratios(view.inFull.frame, trees);
}

const char* nameOf(BenchViewpoint viewpoint) {
    switch (viewpoint) {
    case BenchViewpoint::Over:
        return "over";
    case BenchViewpoint::Home:
        return "home";
    case BenchViewpoint::Inside:
        break;
    }
    return "inside";
}

Json viewJson(const BenchView& view) {
    const osgTreeWind::DrawnTrees trees = view.drawnTrees();
    return {{"forest", view.forest},
            {"view", nameOf(view.viewpoint)},
            {"trees", view.trees},
            {"shapes", view.shapes},
            {"archetypes", view.archetypes},
            {"archetypeBytes", view.archetypeBytes},
            {"loadSeconds", number(view.loadSeconds())},
            {"loadParts",
             {{"forest", number(view.forestSeconds)},
              {"shapes", number(view.shapesSeconds)},
              {"firstFrame", number(view.firstFrameSeconds)}}},
            {"forestBytes", std::isfinite(view.forestBytes)
                                ? Json(static_cast<std::uint64_t>(view.forestBytes))
                                : Json(nullptr)},
            {"tiers", {{"full", trees.full}, {"boughs", trees.byBoughs}, {"impostor", trees.asPictures}}},
            {"drawn", timesJson(view.drawn)},
            {"inFull", view.inFull.frame.empty() ? Json(nullptr) : timesJson(view.inFull)},
            {"tree", timesJson(view.tree)},
            {"ratioToTree", spread(ratios(view.drawn.frame, view.tree.frame))},
            {"processorRatioToTree", spread(ratios(view.drawn.processor, view.tree.processor))},
            {"inFullRatioToTree", spread(inFullRatios(view))}};
}

/// Fixed, with `digits` behind the point; a dash for what was not measured.
std::string fixed(double value, int digits) {
    if (!std::isfinite(value))
        return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

} // namespace

BenchConditions benchConditions(const BenchSettings& settings) {
    BenchConditions conditions;
    conditions.settings = settings;
    conditions.backend = osgTreeWind::offscreenBackendName();
    const std::time_t now = std::time(nullptr);
    char date[32];
    std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&now));
    conditions.date = date;
    if (getloadavg(&conditions.loadBefore, 1) != 1)
        conditions.loadBefore = std::nan("");
    return conditions;
}

std::string machineName() {
    std::string processor = "unknown processor";
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("model name", 0) == 0) {
            processor = line.substr(line.find(':') + 2);
            break;
        }
    }
    utsname system{};
    uname(&system);
    return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors, " +
           system.sysname + " " + system.release + " " + system.machine;
}

double framesPerSecond(const BenchTimes& times) {
    const double milliseconds = std::accumulate(times.frame.begin(), times.frame.end(), 0.0);
    return 1000.0 * static_cast<double>(times.frame.size()) / milliseconds;
}

int thesisFps(const BenchStage& stage, int trees) {
    const auto index = static_cast<std::size_t>(trees - 1);
    return index < stage.thesisFps.size() ? stage.thesisFps[index] : 0;
}

Json benchReport(const BenchConditions& conditions, const BenchReport& report) {
    const BenchSettings& settings = conditions.settings;
    Json json = {{"format", "osgtreewind bench 1"},
                 {"version", OSGTREEWIND_VERSION},
                 {"date", conditions.date},
                 {"machine", machineName()},
                 {"loadBefore", number(conditions.loadBefore)}};
    json["opengl"] = {{"backend", conditions.backend},
                      {"vendor", conditions.driver.vendor},
                      {"renderer", conditions.driver.renderer},
                      {"version", conditions.driver.version}};
    json["settings"] = {{"width", settings.size.width},  {"height", settings.size.height},
                        {"framePairs", settings.frames}, {"warmUpPairs", settings.warmUp},
                        {"stepSeconds", settings.step},  {"threading", "SingleThreaded"}};
    json["results"] = Json::array();
    for (const BenchResult& result : report.results)
        json["results"].push_back(resultJson(result));
    json["kernels"] = Json::array();
    for (const BenchKernel& kernel : report.kernels)
        json["kernels"].push_back({{"group", kernel.group},
                                   {"name", kernel.name},
                                   {"element", kernel.element},
                                   {"elements", kernel.elements},
                                   {"threads", kernel.threads},
                                   {"nanoseconds", spread(kernel.nanoseconds)}});
    json["forests"] = report.forest ? forestJson(*report.forest) : Json(nullptr);
    json["scale"] = Json::array();
    for (const BenchScale& scale : report.scale) {
        json["scale"].push_back(viewJson(scale.view));
        json["scale"].back()["bytesPerTree"] = number(scale.bytesPerTree);
    }
    json["views"] = Json::array();
    for (const BenchView& view : report.views)
        json["views"].push_back(viewJson(view));
    if (report.world)
        json["world"] = worldJson(*report.world);
    json["thesis"] = Json::array();
    for (const BenchStage& stage : benchStages())
        if (!stage.table.empty())
            json["thesis"].push_back(
                {{"stage", stage.name}, {"table", stage.table}, {"fps", stage.thesisFps}});
    return json;
}

void printBenchHead(std::ostream& out, const BenchConditions& conditions) {
    out << conditions.date << ", " << machineName() << ", " << conditions.driver.renderer << " ("
        << conditions.backend << "), " << conditions.settings.size.width << "x"
        << conditions.settings.size.height << ", " << conditions.settings.frames
        << " pairs of frames, times in ms (medians)\n\n| stage | trees";
    for (const char* column : {"fps", "frame", "p10", "p90", "update", "cull", "draw", "GPU", "static",
                               "ratio", "p10", "p90", "thesis fps"})
        out << " | " << column;
    out << " |\n| --- |";
    for (int column = 0; column < 14; ++column)
        out << " ---: |";
    out << '\n';
}

void printBenchRow(std::ostream& out, const BenchResult& result) {
    const BenchTimes& times = result.moving;
    const std::vector<double> paired = ratios(times.frame, result.still.frame);
    const int thesis = thesisFps(result.stage, result.trees);
    out << "| `" << result.stage.name << "` | " << result.trees;
    for (const std::string& cell :
         {fixed(framesPerSecond(times), 1), fixed(quantile(times.frame, 0.5), 2),
          fixed(quantile(times.frame, 0.1), 2), fixed(quantile(times.frame, 0.9), 2),
          fixed(quantile(times.update, 0.5), 2), fixed(quantile(times.cull, 0.5), 2),
          fixed(quantile(times.draw, 0.5), 2), fixed(quantile(times.gpu, 0.5), 2),
          fixed(quantile(result.still.frame, 0.5), 2), fixed(quantile(paired, 0.5), 2),
          fixed(quantile(paired, 0.1), 2), fixed(quantile(paired, 0.9), 2),
          thesis > 0 ? std::to_string(thesis) : std::string("-")})
        out << " | " << cell;
    out << " |" << std::endl; // seen at once: the next result takes its time
}

void printBenchKernels(std::ostream& out, const BenchConditions& conditions,
                       const std::vector<BenchKernel>& kernels) {
    out << '\n'
        << conditions.date << ", " << machineName() << ", " << conditions.settings.frames
        << " rounds\n\n| kernel | of | threads | ns | p10 | p90 | millions a second |\n"
           "| --- | --- | ---: | ---: | ---: | ---: | ---: |\n";
    for (const BenchKernel& kernel : kernels) {
        const double median = quantile(kernel.nanoseconds, 0.5);
        out << "| " << kernel.name << " | " << kernel.element << " | " << kernel.threads << " | "
            << fixed(median, 1) << " | " << fixed(quantile(kernel.nanoseconds, 0.1), 1) << " | "
            << fixed(quantile(kernel.nanoseconds, 0.9), 1) << " | "
            << fixed(1000.0 / median, median < 1000.0 ? 1 : 4) << " |\n";
    }
}

namespace {

/// @param bytes a tree, NaN where not known.
void printView(std::ostream& out, const BenchView& view, double bytes) {
    const osgTreeWind::DrawnTrees trees = view.drawnTrees();
    out << "| " << view.forest << " | " << nameOf(view.viewpoint) << " | " << view.trees;
    for (const std::string& cell :
         {fixed(view.loadSeconds(), 2), fixed(view.forestSeconds, 2), fixed(view.shapesSeconds, 2),
          fixed(view.firstFrameSeconds, 2), fixed(bytes, 0), std::to_string(trees.full),
          std::to_string(trees.byBoughs), std::to_string(trees.asPictures),
          fixed(quantile(view.drawn.update, 0.5), 2), fixed(quantile(view.drawn.cull, 0.5), 2),
          fixed(quantile(view.drawn.draw, 0.5), 2), fixed(quantile(view.drawn.frame, 0.5), 2),
          fixed(quantile(view.tree.frame, 0.5), 2),
          fixed(quantile(ratios(view.drawn.frame, view.tree.frame), 0.5), 2),
          fixed(quantile(ratios(view.drawn.processor, view.tree.processor), 0.5), 2),
          fixed(quantile(inFullRatios(view), 0.5), 1)})
        out << " | " << cell;
    out << " |" << std::endl;
}

void printViewHead(std::ostream& out, const BenchConditions& conditions) {
    out << '\n'
        << conditions.date << ", " << machineName() << ", " << conditions.driver.renderer << ", "
        << conditions.settings.size.width << "x" << conditions.settings.size.height << ", "
        << conditions.settings.frames
        << " rounds, times in ms (medians); over: frame over that of one reference tree that fills the "
           "view\n\n"
           "| forest | view | trees | load, s | forest | its shapes | first frame | bytes a tree | full | "
           "boughs | "
           "impostors | update | cull | draw | frame | tree | over | over, processor | in full, over "
           "|\n"
           "| --- | ---";
    for (int column = 0; column < 17; ++column)
        out << " | ---:";
    out << " |\n";
}

} // namespace

void printBenchScale(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchScale>& scale) {
    printViewHead(out, conditions);
    for (const BenchScale& each : scale)
        printView(out, each.view, each.bytesPerTree);
}

void printBenchViews(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchView>& views) {
    printViewHead(out, conditions);
    for (const BenchView& view : views)
        printView(out, view, std::nan(""));
}

void printBenchForest(std::ostream& out, const BenchConditions& conditions, const BenchForest& forest) {
    out << '\n'
        << conditions.date << ", " << machineName() << ", " << forest.stepMs.size() << " rounds, "
        << forest.threads
        << " threads, without leaves and poses\n\n"
           "| forest | trees | step, ms | p10 | p90 | one core, ms | load, s | processor, s | archetypes | "
           "their MB | bytes a tree |\n| --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: "
           "| "
           "---: |\n| "
        << forest.name << " | " << forest.trees;
    for (const std::string& cell :
         {fixed(quantile(forest.stepMs, 0.5), 2), fixed(quantile(forest.stepMs, 0.1), 2),
          fixed(quantile(forest.stepMs, 0.9), 2), fixed(quantile(forest.oneCoreStepMs, 0.5), 2),
          fixed(forest.loadSeconds, 2), fixed(forest.loadProcessorSeconds, 2),
          std::to_string(forest.archetypes), fixed(1e-6 * static_cast<double>(forest.archetypeBytes), 1),
          fixed(forest.stateBytesPerTree, 0)})
        out << " | " << cell;
    out << " |\n";
}
