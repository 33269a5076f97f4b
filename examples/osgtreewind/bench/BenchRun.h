// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchStage.h>
#include <examples/osgtreewind/bench/BenchViewer.h>

/// Result of one stage with one number of trees. Frames in motion and at rest alternate.
struct BenchResult {
    BenchStage stage;
    int trees = 0;
    std::string angles; ///< Actual source of the angles: "gpu" or "cpu".
    BenchTimes moving, still;
};

struct BenchSettings {
    PictureSize size;
    osgTreeWind::ContextProfile profile = osgTreeWind::osgProfile;
    int frames = 60;          ///< Pairs of frames.
    int warmUp = 10;          ///< Pairs that are not measured, while shaders compile and buffers fill.
    double step = 1.0 / 60.0; ///< Simulation time from one moving frame to the next, seconds.
};

/// Measures a stage in a new OpenGL context. Throws CommandError if no context can be created.
/// @param driver receives the names of the driver.
BenchResult runBench(const BenchStage& stage, int trees, const BenchSettings& settings, BenchDriver& driver);
