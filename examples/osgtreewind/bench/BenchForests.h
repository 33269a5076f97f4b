// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What a step of a whole forest under `modal` costs, without graphics, leaves and poses.
struct BenchForest {
    std::string name;
    unsigned threads = 1;
    std::size_t trees = 0, nearTrees = 0, units = 0;
    double loadSeconds = 0.0;          ///< From the description to trees at rest: shapes, places, archetypes.
    double loadProcessorSeconds = 0.0; ///< The same, of all threads.
    std::size_t archetypes = 0, archetypeBytes = 0;
    double stateBytesPerTree = 0.0;
    std::vector<double> stepMs;        ///< A number a round, as a simulation does by default.
    std::vector<double> oneCoreStepMs; ///< The same in one thread.
};

/// A wind that swings for a thousand seconds, as a record has it.
osgTreeWind::WindFieldPtr createSeries();

/// A wood of spruce, pine, beech, oak and birch in rows, three shapes each, 4 to 32 m high, in a wind.
osgTreeWind::ForestDescription createWood(std::size_t trees);

/// One tree in fifty is near, the others are far. @param described a forest; none: a wood of so many `trees`
/// in a time series. @param file its name. @param rounds 1 or more.
BenchForest runBenchForest(const std::optional<osgTreeWind::ForestDescription>& described,
                           const std::string& file, std::size_t trees, int rounds);
