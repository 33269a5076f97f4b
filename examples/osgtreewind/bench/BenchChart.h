// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchReport.h>

/// A chart like Fig 6.1 of the thesis, as an SVG document: frames a second over the number of trees, on the
/// left as published, on the right as measured.
std::string benchChart(const BenchConditions& conditions, const std::vector<BenchResult>& results);
