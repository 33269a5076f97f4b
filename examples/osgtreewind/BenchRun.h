// SPDX-License-Identifier: MIT
#pragma once

#include "BenchStage.h"
#include "Offscreen.h"

#include <osgTreeWind/base/Result.h>

/// How a frame spent its time; a number a frame, milliseconds.
struct BenchTimes {
    std::vector<double> frame;              ///< Whole frames, up to the end of the driver's work (glFinish).
    std::vector<double> update, cull, draw; ///< What osgViewer measured; draw includes the glFinish.
    std::vector<double> gpu;                ///< Likewise; empty where there are no timer queries.
};

/// What the moving scene consists of.
struct BenchCounts {
    std::uint64_t units = 0, vertices = 0, triangles = 0, lines = 0;
    std::uint64_t nodes = 0, transforms = 0, drawables = 0;
};

/// One stage with one number of trees: frames with the trees in motion and at rest, in turns.
struct BenchResult {
    BenchStage stage;
    int trees = 0;
    bool gpuAngles = false; ///< Whether the angles came from the GPU in fact.
    BenchTimes moving, still;
    BenchCounts counts;
};

struct BenchSettings {
    PictureSize size;
    int frames = 60;          ///< Pairs of frames.
    int warmUp = 10;          ///< Pairs before them: shaders compile, buffers fill, angle passes start.
    double step = 1.0 / 60.0; ///< Simulation time from one moving frame to the next, seconds.
};

/// What OpenGL says of itself.
struct BenchDriver {
    std::string vendor, renderer, version;
};

/// Measures in a context of its own. @param driver is filled in.
osgTreeWind::Result<BenchResult> runBench(const BenchStage& stage, int trees, const BenchSettings& settings,
                                          BenchDriver& driver);
