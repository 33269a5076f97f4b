// SPDX-License-Identifier: MIT
#pragma once

#include "BenchForests.h"
#include "BenchKernels.h"
#include "BenchRun.h"
#include "BenchView.h"

#include <nlohmann/json.hpp>

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

/// All that was measured; empty where it was not.
struct BenchReport {
    std::vector<BenchResult> results;
    std::vector<BenchKernel> kernels;
    std::optional<BenchForests> forests;
    std::vector<BenchScale> scale;
    std::vector<BenchView> views;
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
nlohmann::ordered_json benchReport(const BenchConditions& conditions, const BenchReport& report);

// The same for people, as a Markdown table.
void printBenchHead(std::ostream& out, const BenchConditions& conditions);
void printBenchRow(std::ostream& out, const BenchResult& result);
void printBenchKernels(std::ostream& out, const BenchConditions& conditions,
                       const std::vector<BenchKernel>& kernels);
void printBenchForests(std::ostream& out, const BenchConditions& conditions, const BenchForests& forests);
void printBenchScale(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchScale>& scale);
void printBenchViews(std::ostream& out, const BenchConditions& conditions,
                     const std::vector<BenchView>& views);
