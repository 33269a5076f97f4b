// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchRun.h>

#include <osgTreeWind/drawing/instanced/DrawnTrees.h>

#include <array>
#include <cmath>

/// From where a forest is looked at.
enum class BenchViewpoint {
    Over,  ///< Where `render --view above` looks from.
    Home,  ///< Where osgviewer starts: from the south, level.
    Inside ///< A person in its middle, who looks north.
};

/// A whole forest drawn from a view of it, in turns with one reference tree that fills the view.
struct BenchView {
    std::string forest; ///< A file, or "made trees".
    BenchViewpoint viewpoint = BenchViewpoint::Over;
    std::size_t trees = 0, shapes = 0, archetypes = 0, archetypeBytes = 0;
    // Load: from the description to the end of the first frame.
    double forestSeconds = 0.0;     ///< A Forest out of the description.
    double shapesSeconds = 0.0;     ///< Of that, about: meshes of all tiers, impostors painted.
    double firstFrameSeconds = 0.0; ///< Shaders compile, buffers and textures go to the GPU.
    /// Main memory that the Forest took, before anything was drawn; NaN where the allocator does not say.
    double forestBytes = std::nan("");
    /// Of it a tree, beyond shapes and archetypes; NaN where not known or for too few trees.
    double bytesPerTree = std::nan("");
    std::array<std::size_t, osgTreeWind::tierCount>
        tiers{};                    ///< Trees drawn by tier; one across two counts twice.
    BenchTimes drawn, inFull, tree; ///< Round by round; `inFull` in each 10th, or none.
    static constexpr int roundsPerFull = 10;

    osgTreeWind::DrawnTrees drawnTrees() const { return osgTreeWind::DrawnTrees(tiers); }
    double loadSeconds() const { return forestSeconds + firstFrameSeconds; }
};

/// @param make called once, for the description. @param inFull whether to draw it without tiers as well.
BenchView runBenchView(const std::string& name, const std::function<osgTreeWind::ForestDescription()>& make,
                       BenchViewpoint viewpoint, bool inFull, const BenchSettings& settings,
                       BenchDriver& driver);

/// Woods of so many trees each (createWood()), with what each takes of main memory.
std::vector<BenchView> runBenchScale(const std::vector<int>& trees, const BenchSettings& settings,
                                     BenchDriver& driver);
