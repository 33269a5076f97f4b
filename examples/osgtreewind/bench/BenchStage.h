// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/motion/ForestSimulation.h>
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

    enum Way {
        BRANCHWISE,        ///< Forest under the law `thesis`, angles as below.
        INSTANCES,         ///< Forest under the law `modal`, as it comes: with tiers.
        INSTANCES_IN_FULL, ///< The same without tiers.
        HARDWARE_RIG,      ///< osgAnimation, skinned by a vertex shader.
        SOFTWARE_RIG       ///< osgAnimation, skinned by the CPU.
    };

    std::string name;
    std::string title;
    Geometry geometry;
    Way way;
    std::string table{};          ///< Of the thesis; empty for a stage it does not have.
    std::vector<int> thesisFps{}; ///< That table: frames a second for 1, 2, 3 and 4 trees.
    osgTreeWind::BranchwiseForest::AngleSource angles = osgTreeWind::BranchwiseForest::GPU_ANGLES;

    /// That moves the trees.
    osgTreeWind::MotionLaw law() const {
        return way == BRANCHWISE ? osgTreeWind::MotionLaw::Thesis : osgTreeWind::MotionLaw::Modal;
    }
};

/// All stages, those of the thesis first, in its order.
const std::vector<BenchStage>& benchStages();

/// The same trees twice, of which one is to be shown at a time.
struct BenchScene {
    osg::ref_ptr<osg::Node> moving;
    osg::ref_ptr<osgTreeWind::Forest> forest; ///< `moving`; null where it is none.
    osg::ref_ptr<osg::Group> still; ///< At rest, in the fewest draws: one of bark and one of leaves a tree.
    std::shared_ptr<const osgTreeWind::TreeModel> model; ///< Of all trees.
};

/// Reference trees of the thesis in rows, 6 m apart.
BenchScene createBenchScene(const BenchStage& stage, int trees);

/// A wind for them in the form of the thesis' forestWind array (§4.2), which turns round every 30 steps, so
/// that the trees sway about their rest.
class BenchWinds {
public:
    BenchWinds();
    const osgTreeWind::WindFieldPtr& at(int step) const { return _winds[step / stepsPerWind % 2]; }

private:
    static constexpr int stepsPerWind = 30;
    osgTreeWind::WindFieldPtr _winds[2];
};
