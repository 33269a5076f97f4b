// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchStage.h>
#include <examples/osgtreewind/bench/BenchViewer.h>

/// Contents of the moving scene.
struct BenchCounts {
    std::uint64_t units = 0, vertices = 0, triangles = 0, lines = 0;
    std::uint64_t nodes = 0, transforms = 0, drawables = 0;
};

/// Result of one stage with one number of trees. Frames in motion and at rest alternate.
struct BenchResult {
    BenchStage stage;
    int trees = 0;
    std::string angles; ///< Actual source of the angles: "gpu", "cpu" or "recorded".
    BenchTimes moving, still;
    BenchCounts counts;
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
