// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchView.h>
#include <examples/osgtreewind/bench/GlCounts.h>

/// OpenGL calls of a standard scene, and the work of its draws.
struct BenchCalls {
    std::string scene;
    std::size_t trees = 0; ///< Drawn; a tree that fades between two tiers counts twice.
    int frames = 0;
    GlCounts counts;               ///< Calls of all `frames`.
    bool hasWork = false;          ///< Whether the driver counts the work of draws.
    decltype(GlCounts::work) work; ///< Of one frame, if `hasWork`.

    DrawWork allWork() const;
    double perFrame(std::uint64_t count) const { return static_cast<double>(count) / frames; }
};

/// Counts views of createWood() and of one reference tree.
std::vector<BenchCalls> runBenchCalls(const BenchSettings& settings, BenchDriver& driver);

/// Counts the view of a forest at eye level that `render` has by default.
BenchCalls runBenchCalls(const std::string& name, const osgTreeWind::ForestDescription& forest,
                         const BenchSettings& settings, BenchDriver& driver);
