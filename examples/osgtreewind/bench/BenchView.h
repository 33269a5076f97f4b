// SPDX-License-Identifier: MIT
#pragma once

#include <examples/osgtreewind/bench/BenchRun.h>

#include <osgTreeWind/drawing/instanced/DrawnTrees.h>

#include <array>
#include <cmath>

/// Viewpoint of a forest.
enum class BenchViewpoint {
    Over,  ///< As `render --view above`.
    Home,  ///< Start of osgviewer: level, from the south.
    Inside ///< At eye level in the middle, looking north.
};

/// Times of a forest in one view. Its frames alternate with frames of one reference tree that fills the view.
struct BenchView {
    std::string forest; ///< Name of a file, or "made trees".
    BenchViewpoint viewpoint = BenchViewpoint::Over;
    std::size_t trees = 0, shapes = 0, archetypes = 0, archetypeBytes = 0;
    // Loading: from the description to the end of the first frame.
    double forestSeconds = 0.0;     ///< Making a Forest from the description.
    double firstFrameSeconds = 0.0; ///< Including shader compilation and uploads.
    /// Memory of the Forest before drawing; NaN if the allocator does not report it.
    double forestBytes = std::nan("");
    /// Memory per tree without shapes and archetypes; NaN if unknown or for too few trees.
    double bytesPerTree = std::nan("");
    std::array<std::size_t, osgTreeWind::tierCount>
        tiers{};                    ///< Trees drawn by tier; a tree that fades between two counts twice.
    BenchTimes drawn, inFull, tree; ///< By round; `inFull` in every 10th round, or empty.
    static constexpr int roundsPerFull = 10;

    osgTreeWind::DrawnTrees drawnTrees() const { return osgTreeWind::DrawnTrees(tiers); }
    double loadSeconds() const { return forestSeconds + firstFrameSeconds; }
};

/// The stage that draws trees as a Forest does by default.
const BenchStage& stageOfInstances();

osg::Matrixd viewOf(const osg::BoundingSphere& bound, BenchViewpoint viewpoint, const PictureSize& size);

/// Measures one view. @param make makes the description. @param inFull also draw the forest without tiers.
BenchView runBenchView(const std::string& name, const std::function<osgTreeWind::ForestDescription()>& make,
                       BenchViewpoint viewpoint, bool inFull, const BenchSettings& settings,
                       BenchDriver& driver);

/// Measures forests of createWood() with the given numbers of trees, and their memory.
std::vector<BenchView> runBenchScale(const std::vector<int>& trees, const BenchSettings& settings,
                                     BenchDriver& driver);
