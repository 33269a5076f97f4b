// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchCalls.h>
#include <examples/osgtreewind/bench/BenchRun.h>
#include <examples/osgtreewind/bench/BenchView.h>
#include <examples/osgtreewind/output/Json.h>

#include <iosfwd>
#include <optional>

/// Machine and settings of a measurement.
struct BenchConditions {
    std::string date;      ///< ISO 8601, UTC.
    double loadBefore = 0; ///< Load average of the minute before.
    std::string backend;
    BenchDriver driver;
    BenchSettings settings;
};

/// Results of a flight through a forest in tiles.
struct BenchWorld {
    static constexpr double speed = 100.0; ///< m/s
    std::string forest;                    ///< Name of the file.
    std::size_t trees = 0, mostTrees = 0;  ///< In total; most at one time.
    double range = 0.0;                    ///< Metres.
    /// Time until the first frame, and until the first one with all trees in range.
    double firstFrameSeconds = 0.0, firstPictureSeconds = 0.0;
    double flownSeconds = 0.0,
           missingSeconds = 0.0; ///< Longest time that a tile within half the range was missing.
    std::vector<double> frameMs;
    double halfwayBytes = 0.0, endBytes = 0.0, mostBytes = 0.0; ///< Main memory of the process.
    double bytesRead = 0.0;
};

/// All results; empty for stages that were not measured.
struct BenchReport {
    std::vector<BenchResult> results;
    std::vector<BenchView> scale, views;
    std::optional<BenchWorld> world;
    std::vector<BenchCalls> calls;
};

/// Records date and load.
BenchConditions benchConditions(const BenchSettings& settings);

/// Name of the machine, such as "AMD EPYC, 2 processors, Linux 6.1.0 x86_64".
std::string machineName();

/// Frames divided by seconds. (Chapter 6 of the thesis prints the inverse, but its tables hold frames per
/// second.)
double framesPerSecond(const BenchTimes& times);

/// Frames per second in the thesis for this stage and number of trees; 0 if the thesis did not measure them.
int thesisFps(const BenchStage& stage, int trees);

/// The JSON document described in docs/results.md.
Json benchReport(const BenchConditions& conditions, const BenchReport& report);

// The same as Markdown tables.
void printBenchHead(std::ostream& out, const BenchConditions& conditions);
void printBenchRow(std::ostream& out, const BenchResult& result);
void printBenchViews(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchView>& views);
void printBenchWorld(std::ostream& out, const BenchConditions& conditions, const BenchWorld& world);
void printBenchCalls(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchCalls>& calls);

/// Flies through a forest in tiles at 100 m/s in real time, 80 m above its trees, on an ellipse around its
/// middle.
/// @param forest must have tiles.
BenchWorld runBenchWorld(const std::string& name, const osgTreeWind::ForestDescription& forest,
                         const BenchSettings& settings, BenchDriver& driver);
