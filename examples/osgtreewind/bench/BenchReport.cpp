// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchReport.h>

#include <examples/osgtreewind/bench/BenchStatistics.h>

#include <osgTreeWind/base/DateText.h>
#include <osgTreeWind/offscreen/OffscreenContext.h>
#include <osgTreeWind/system/Machine.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <numeric>
#include <ostream>
#include <sstream>
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

Json resultJson(const BenchResult& result) {
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
    json["thesisTable"] = result.stage.table.empty() ? Json(nullptr) : Json(result.stage.table);
    json["thesisFps"] = thesis > 0 ? Json(thesis) : Json(nullptr);
    return json;
}

/// Frame times of the forest in full over those of the reference tree in the same rounds.
std::vector<double> inFullRatios(const BenchView& view) {
    std::vector<double> trees;
    for (std::size_t i = 0; i < view.inFull.frame.size(); ++i)
        trees.push_back(view.tree.frame[i * BenchView::roundsPerFull]);
    return ratios(view.inFull.frame, trees);
}

Json worldJson(const BenchWorld& world) {
    return {{"forest", world.forest},
            {"trees", world.trees},
            {"range", world.range},
            {"firstFrameSeconds", world.firstFrameSeconds},
            {"firstPictureSeconds", world.firstPictureSeconds},
            {"frames", world.frameMs.size()},
            {"flownSeconds", world.flownSeconds},
            {"frameMs",
             {{"median", quantile(world.frameMs, 0.5)},
              {"p99", quantile(world.frameMs, 0.99)},
              {"worst", quantile(world.frameMs, 1.0)}}},
            {"missingSeconds", world.missingSeconds},
            {"mostTrees", world.mostTrees},
            {"halfwayBytes", world.halfwayBytes},
            {"endBytes", world.endBytes},
            {"mostBytes", world.mostBytes},
            {"bytesRead", world.bytesRead}};
}

const char* nameOf(BenchViewpoint viewpoint) {
    constexpr const char* names[] = {"over", "home", "inside"};
    return names[static_cast<std::size_t>(viewpoint)];
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
             {{"forest", number(view.forestSeconds)}, {"firstFrame", number(view.firstFrameSeconds)}}},
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

Json callsJson(const BenchCalls& calls) {
    Json json = {{"scene", calls.scene},
                 {"trees", calls.trees},
                 {"frames", calls.frames},
                 {"bufferBytes", calls.perFrame(calls.counts.bufferBytes)},
                 {"textureBytes", calls.perFrame(calls.counts.textureBytes)},
                 {"work", nullptr}};
    for (std::size_t i = 0; i < glCallNames.size(); ++i)
        json["calls"][glCallNames[i]] = calls.perFrame(calls.counts.calls[i]);
    for (std::size_t i = 0; calls.hasWork && i < drawnPartNames.size(); ++i) {
        Json& part = json["work"][drawnPartNames[i]];
        part["draws"] = calls.work[i].draws;
        for (std::size_t count = 0; count < DrawWork::names.size(); ++count)
            part[DrawWork::names[count]] = calls.work[i].counts[count];
    }
    return json;
}

/// Date, machine and driver, for the head of a table.
std::string whereMeasured(const BenchConditions& conditions, const std::string& backend = "") {
    const PictureSize& size = conditions.settings.size;
    return conditions.date + ", " + machineName() + ", " + conditions.driver.renderer + backend + ", " +
           std::to_string(size.width) + "x" + std::to_string(size.height) + ", ";
}

using Row = std::vector<std::string>;

void printRow(std::ostream& out, const Row& cells) {
    for (const std::string& cell : cells)
        out << "| " << cell << ' ';
    out << '|' << std::endl; // flushed: the next result takes a while
}

/// @param words number of columns with text; the others have numbers.
void printHead(std::ostream& out, const Row& columns, std::size_t words) {
    printRow(out, columns);
    for (std::size_t i = 0; i < columns.size(); ++i)
        out << (i < words ? "| --- " : "| ---: ");
    out << "|\n";
}

/// Number with `digits` decimals; a dash if it was not measured.
std::string fixed(double value, int digits) {
    if (!std::isfinite(value))
        return "-";
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

std::string median(const std::vector<double>& values, int digits = 2) {
    return fixed(quantile(values, 0.5), digits);
}

/// Columns named like fields: "instanced draws" for `instancedDraws`.
template <class Names>
void addColumns(Row& row, const Names& names) {
    for (const std::string name : names) {
        std::string& words = row.emplace_back();
        for (const char letter : name)
            words += std::isupper(letter) ? std::string{' ', static_cast<char>(std::tolower(letter))}
                                          : std::string{letter};
    }
}

/// Least times that the counts allow on a GeForce RTX 3060 (docs/frame.md).
void printBounds(std::ostream& out, const std::vector<BenchCalls>& calls) {
    constexpr double clock = 1.777e6; // all rates are per millisecond
    constexpr std::pair<DrawWork::Count, double> rates[] = {{DrawWork::ClippedPrimitives, 3 * clock},
                                                            {DrawWork::LeastTextureFetches, 112 * clock},
                                                            {DrawWork::TextureFetches, 112 * clock},
                                                            {DrawWork::Fragments, 48 * clock}};
    constexpr double busBytes = 31.5e6, callCount = 1e4;
    out << "\nLeast times on a GeForce RTX 3060, ms\n\n";
    printHead(out,
              {"scene", "clipped primitives", "least texture fetches", "texture fetches", "fragments",
               "uploads", "calls"},
              1);
    for (const BenchCalls& scene : calls) {
        Row row = {scene.scene};
        for (const auto& [count, rate] : rates)
            row.push_back(fixed(static_cast<double>(scene.allWork().counts[count]) / rate, 3));
        row.push_back(
            fixed(scene.perFrame(scene.counts.bufferBytes + scene.counts.textureBytes) / busBytes, 3));
        row.push_back(fixed(scene.perFrame(scene.counts.allCalls()) / callCount, 3));
        printRow(out, row);
    }
}

} // namespace

BenchConditions benchConditions(const BenchSettings& settings) {
    BenchConditions conditions;
    conditions.settings = settings;
    conditions.backend = osgTreeWind::offscreenBackendName();
    conditions.date = osgTreeWind::isoTimeText(static_cast<double>(std::time(nullptr)));
    conditions.loadBefore = osgTreeWind::machineLoad().value_or(std::nan(""));
    return conditions;
}

std::string machineName() {
    return osgTreeWind::processorName() + ", " + std::to_string(std::thread::hardware_concurrency()) +
           " processors, " + osgTreeWind::systemName();
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
    json["scale"] = Json::array();
    for (const BenchView& view : report.scale) {
        json["scale"].push_back(viewJson(view));
        json["scale"].back()["bytesPerTree"] = number(view.bytesPerTree);
    }
    json["views"] = Json::array();
    for (const BenchView& view : report.views)
        json["views"].push_back(viewJson(view));
    if (report.world)
        json["world"] = worldJson(*report.world);
    for (const BenchCalls& calls : report.calls)
        json["calls"].push_back(callsJson(calls));
    return json;
}

void printBenchHead(std::ostream& out, const BenchConditions& conditions) {
    out << whereMeasured(conditions, " (" + conditions.backend + ')') << conditions.settings.frames
        << " pairs of frames, times in ms (medians)\n\n";
    printHead(out,
              {"stage", "trees", "fps", "frame", "p10", "p90", "update", "cull", "draw", "GPU", "static",
               "ratio", "p10", "p90", "thesis fps"},
              1);
}

void printBenchRow(std::ostream& out, const BenchResult& result) {
    const BenchTimes& times = result.moving;
    const std::vector<double> paired = ratios(times.frame, result.still.frame);
    const int thesis = thesisFps(result.stage, result.trees);
    printRow(out,
             {'`' + result.stage.name + '`', std::to_string(result.trees), fixed(framesPerSecond(times), 1),
              median(times.frame), fixed(quantile(times.frame, 0.1), 2), fixed(quantile(times.frame, 0.9), 2),
              median(times.update), median(times.cull), median(times.draw), median(times.gpu),
              median(result.still.frame), median(paired), fixed(quantile(paired, 0.1), 2),
              fixed(quantile(paired, 0.9), 2), thesis > 0 ? std::to_string(thesis) : "-"});
}

void printBenchViews(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchView>& views) {
    out << '\n'
        << whereMeasured(conditions) << conditions.settings.frames
        << " rounds, times in ms (medians); over: frame time over that of one reference tree that fills "
           "the view\n\n";
    printHead(out,
              {"forest", "view", "trees", "load, s", "forest", "first frame", "bytes a tree", "full",
               "boughs", "impostors", "update", "cull", "draw", "frame", "tree", "over", "over, processor",
               "in full, over"},
              2);
    for (const BenchView& view : views) {
        const osgTreeWind::DrawnTrees trees = view.drawnTrees();
        printRow(out,
                 {view.forest, nameOf(view.viewpoint), std::to_string(view.trees),
                  fixed(view.loadSeconds(), 2), fixed(view.forestSeconds, 2),
                  fixed(view.firstFrameSeconds, 2), fixed(view.bytesPerTree, 0), std::to_string(trees.full),
                  std::to_string(trees.byBoughs), std::to_string(trees.asPictures), median(view.drawn.update),
                  median(view.drawn.cull), median(view.drawn.draw), median(view.drawn.frame),
                  median(view.tree.frame), median(ratios(view.drawn.frame, view.tree.frame)),
                  median(ratios(view.drawn.processor, view.tree.processor)), median(inFullRatios(view), 1)});
    }
}

void printBenchWorld(std::ostream& out, const BenchConditions& conditions, const BenchWorld& world) {
    out << '\n'
        << whereMeasured(conditions) << world.frameMs.size() << " frames, " << fixed(world.flownSeconds, 0)
        << " s at " << fixed(BenchWorld::speed, 0) << " m/s\n\n";
    printHead(out,
              {"world", "trees", "range, m", "first frame, s", "first picture, s", "frame, ms", "p99",
               "worst", "missing, s", "most trees", "memory halfway, MB", "end", "most", "read, MB"},
              1);
    printRow(out, {world.forest, std::to_string(world.trees), fixed(world.range, 0),
                   fixed(world.firstFrameSeconds, 2), fixed(world.firstPictureSeconds, 2),
                   median(world.frameMs, 0), fixed(quantile(world.frameMs, 0.99), 0),
                   fixed(quantile(world.frameMs, 1.0), 0), fixed(world.missingSeconds, 1),
                   std::to_string(world.mostTrees), fixed(1e-6 * world.halfwayBytes, 0),
                   fixed(1e-6 * world.endBytes, 0), fixed(1e-6 * world.mostBytes, 0),
                   fixed(1e-6 * world.bytesRead, 0)});
}

void printBenchCalls(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchCalls>& calls) {
    out << '\n'
        << whereMeasured(conditions, " (" + conditions.backend + ')') << "OpenGL calls in a frame, means of "
        << conditions.settings.frames << "\n\n";
    Row head = {"scene", "trees", "calls"};
    addColumns(head, glCallNames);
    head.insert(head.end(), {"buffers, kB", "textures, kB"});
    printHead(out, head, 1);
    for (const BenchCalls& scene : calls) {
        Row row = {scene.scene, std::to_string(scene.trees),
                   fixed(scene.perFrame(scene.counts.allCalls()), 0)};
        for (const std::uint64_t count : scene.counts.calls)
            row.push_back(fixed(scene.perFrame(count), 0));
        for (const std::uint64_t bytes : {scene.counts.bufferBytes, scene.counts.textureBytes})
            row.push_back(fixed(1e-3 * scene.perFrame(bytes), 1));
        printRow(out, row);
    }
    out << "\nWork of the draws of a frame, thousands; texture fetches are computed from the shaders\n\n";
    head = {"scene", "part", "draws"};
    addColumns(head, DrawWork::names);
    printHead(out, head, 2);
    const auto print = [&out](const std::string& scene, const std::string& part, const DrawWork& work) {
        Row row = {scene, part, std::to_string(work.draws)};
        for (const std::uint64_t count : work.counts)
            row.push_back(fixed(1e-3 * static_cast<double>(count), 0));
        printRow(out, row);
    };
    for (const BenchCalls& scene : calls) {
        for (std::size_t i = 0; i < drawnPartNames.size(); ++i)
            if (scene.work[i].draws)
                print(scene.scene, drawnPartNames[i], scene.work[i]);
        print(scene.scene, "all", scene.allWork());
    }
    printBounds(out, calls);
}
