// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchStage.h>
#include <examples/osgtreewind/bench/BenchViewer.h>

/// What the moving scene consists of.
struct BenchCounts {
    std::uint64_t units = 0, vertices = 0, triangles = 0, lines = 0;
    std::uint64_t nodes = 0, transforms = 0, drawables = 0;
};

/// One stage with one number of trees: frames with the trees in motion and at rest, in turns.
struct BenchResult {
    BenchStage stage;
    int trees = 0;
    std::string angles; ///< Where the angles came from in fact: "gpu", "cpu" or "recorded".
    BenchTimes moving, still;
    BenchCounts counts;
};

struct BenchSettings {
    PictureSize size;
    int frames = 60;          ///< Pairs of frames.
    int warmUp = 10;          ///< Pairs before them: shaders compile, buffers fill, angle passes start.
    double step = 1.0 / 60.0; ///< Simulation time from one moving frame to the next, seconds.
};

/// Measures in a context of its own. The command ends if no context can be made.
/// @param driver is filled in.
BenchResult runBench(const BenchStage& stage, int trees, const BenchSettings& settings, BenchDriver& driver);
