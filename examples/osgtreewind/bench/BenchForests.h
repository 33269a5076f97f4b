// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/forest/ForestDescription.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// What a step of a whole forest costs, without graphics and leaves.
struct BenchForest {
    std::string name, law;
    std::size_t trees = 0, nearTrees = 0, units = 0;
    double loadSeconds = 0.0;          ///< From the description to trees at rest: shapes, places, archetypes.
    double loadProcessorSeconds = 0.0; ///< The same, of all threads.
    std::size_t archetypes = 0, archetypeBytes = 0;
    double stateBytesPerTree = 0.0;    ///< 0 where it is not known.
    std::vector<double> stepMs;        ///< A number a round, as a simulation does by default.
    std::vector<double> oneCoreStepMs; ///< The same in one thread.
};

/// Both stepped in turns in the same wind, a time series.
struct BenchForests {
    BenchForest damped; ///< With the poses of all trees, which that law always works out, in one thread.
    BenchForest modal;  ///< Without poses; one tree in fifty near, the others far; in all threads.
    unsigned threads = 1;
};

/// A wind that swings for a thousand seconds, as a record has it.
osgTreeWind::WindFieldPtr createSeries();

/// A wood of spruce, pine, beech, oak and birch in rows, three shapes each, 4 to 32 m high, in a wind.
osgTreeWind::ForestDescription createWood(std::size_t trees);

/// @param described the forest under `damped`; none: 1,233 made trees, as large as those of
/// examples/campus.treewind. @param file its name. @param trees under `modal`. @param rounds 1 or more.
BenchForests runBenchForests(const std::optional<osgTreeWind::ForestDescription>& described,
                             const std::string& file, std::size_t trees, int rounds);
