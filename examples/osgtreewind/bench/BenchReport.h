// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchRun.h>
#include <examples/osgtreewind/bench/BenchView.h>
#include <examples/osgtreewind/output/Json.h>

#include <iosfwd>
#include <optional>

/// Where and how results were measured.
struct BenchConditions {
    std::string date;      ///< ISO 8601, UTC.
    double loadBefore = 0; ///< Processes that wanted to run in the minute before.
    std::string backend;
    BenchDriver driver;
    BenchSettings settings;
};

/// A flight through a forest in tiles.
struct BenchWorld {
    static constexpr double speed = 100.0; ///< m/s
    std::string forest;                    ///< A file.
    std::size_t trees = 0, mostTrees = 0;  ///< In all; at a time.
    double range = 0.0;                    ///< Metres.
    /// From the description on: the first frame, and the first with all trees in range.
    double firstFrameSeconds = 0.0, firstPictureSeconds = 0.0;
    double flownSeconds = 0.0,
           missingSeconds = 0.0; ///< The longest that a tile within half the range was missing.
    std::vector<double> frameMs;
    double halfwayBytes = 0.0, endBytes = 0.0, mostBytes = 0.0; ///< Main memory of the process.
    double bytesRead = 0.0;
};

/// All that was measured; empty where it was not.
struct BenchReport {
    std::vector<BenchResult> results;
    std::vector<BenchView> scale, views;
    std::optional<BenchWorld> world;
};

/// Takes date and load now.
BenchConditions benchConditions(const BenchSettings& settings);

/// "AMD EPYC, 2 processors, Linux 6.1.0 x86_64", as far as the system says.
std::string machineName();

/// Frames over seconds. (Chapter 6 of the thesis prints seconds over frames, but its tables are frames a
/// second.)
double framesPerSecond(const BenchTimes& times);

/// What the thesis measured for this stage and number of trees; 0 when it did not.
int thesisFps(const BenchStage& stage, int trees);

/// The document that docs/results.md describes.
Json benchReport(const BenchConditions& conditions, const BenchReport& report);

// The same for people, as a Markdown table.
void printBenchHead(std::ostream& out, const BenchConditions& conditions);
void printBenchRow(std::ostream& out, const BenchResult& result);
void printBenchViews(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchView>& views);
void printBenchWorld(std::ostream& out, const BenchConditions& conditions, const BenchWorld& world);

/// A flight through a forest in tiles: at 100 m/s of real time, 80 m above its trees, on an ellipse about its
/// middle. Frames are drawn one after the other, however long they take.
/// @param forest with tiles.
BenchWorld runBenchWorld(const std::string& name, const osgTreeWind::ForestDescription& forest,
                         const BenchSettings& settings, BenchDriver& driver);

/// A chart like Fig 6.1 of the thesis, as an SVG document: frames a second over the number of trees, on the
/// left as published, on the right as measured.
std::string benchChart(const BenchConditions& conditions, const std::vector<BenchResult>& results);
