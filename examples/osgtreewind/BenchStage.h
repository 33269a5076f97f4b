// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/nodes/Forest.h>

#include <string>
#include <vector>

/// What is measured at one step of the thesis' chapter 6, or beyond it.
struct BenchStage {
    enum Geometry {
        LINES,          ///< Skeletons of 1,952 points, sent by the CPU every frame.
        BUFFERED_LINES, ///< The same in vertex buffer objects.
        BARK,
        BARK_AND_LEAVES
    };

    std::string name;
    std::string title;
    std::string table;          ///< Of the thesis; empty for a stage it does not have.
    std::vector<int> thesisFps; ///< That table: frames a second for 1, 2, 3 and 4 trees.
    Geometry geometry;
    osgTreeWind::BranchwiseForest::AngleSource angles;
    osgTreeWind::BranchwiseForest::BranchDrawing branches;
    osgTreeWind::BranchwiseForest::LeafDrawing leaves;
};

/// All stages, in the order of the thesis.
const std::vector<BenchStage>& benchStages();

/// The same trees twice, of which one is to be shown at a time.
struct BenchScene {
    osg::ref_ptr<osgTreeWind::Forest> moving;
    osg::ref_ptr<osg::Group> still; ///< At rest, in the fewest draws: one of bark and one of leaves a tree.
};

/// Reference trees of the thesis in rows, 6 m apart, under the law `thesis`.
BenchScene createBenchScene(const BenchStage& stage, int trees);

/// A wind for them in the form of the thesis' forestWind array (§4.2).
/// @param turned the same wind from the opposite direction.
osgTreeWind::WindFieldPtr createBenchWind(bool turned);
