// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchReport.h>

#include <osgTreeWind/forest/ForestDescription.h>

#include <string>

/// A flight through a forest in tiles: at 100 m/s of real time, 80 m above its trees, on an ellipse about its
/// middle. Frames are drawn one after the other, however long they take.
/// @param forest with tiles.
BenchWorld runBenchWorld(const std::string& name, const osgTreeWind::ForestDescription& forest,
                         const BenchSettings& settings, BenchDriver& driver);
