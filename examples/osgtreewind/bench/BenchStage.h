// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>

#include <string>
#include <vector>

/// A stage of chapter 6 of the thesis, or a further one.
struct BenchStage {
    enum Geometry {
        LINES,          ///< Skeletons of 1,952 points, sent by the CPU every frame.
        BUFFERED_LINES, ///< The same in vertex buffer objects.
        BARK,
        BARK_AND_LEAVES
    };

    enum Method {
        BRANCHWISE,       ///< Forest under the law `thesis`, angles as below.
        INSTANCES,        ///< Forest under the law `modal` with its default tiers.
        INSTANCES_IN_FULL ///< The same without tiers of detail.
    };

    std::string name;
    std::string title;
    Geometry geometry;
    Method method;
    std::string table{};          ///< Table of the thesis; empty if the thesis does not have this stage.
    std::vector<int> thesisFps{}; ///< Frames per second in that table, for 1, 2, 3 and 4 trees.
    osgTreeWind::BranchwiseForest::AngleSource angles = osgTreeWind::BranchwiseForest::GPU_ANGLES;

    /// Law that moves the trees.
    osgTreeWind::MotionLaw law() const {
        return method == BRANCHWISE ? osgTreeWind::MotionLaw::Thesis : osgTreeWind::MotionLaw::Modal;
    }
};

/// All stages: first those of the thesis, in its order.
const std::vector<BenchStage>& benchStages();

/// The same trees in motion and at rest; only one of the two is shown at a time.
struct BenchScene {
    osg::ref_ptr<osgTreeWind::Forest> forest; ///< In motion.
    osg::ref_ptr<osg::Group> still;           ///< At rest, with two draw calls per tree: bark and leaves.
};

/// Makes reference trees of the thesis in rows, 6 m apart.
BenchScene createBenchScene(const BenchStage& stage, int trees);

/// Wind in the form of the thesis' forestWind array (§4.2). It reverses every 30 steps, so that the trees
/// sway about their rest position.
class BenchWinds {
public:
    BenchWinds();
    const osgTreeWind::WindFieldPtr& at(int step) const { return _winds[step / stepsPerWind % 2]; }

private:
    static constexpr int stepsPerWind = 30;
    osgTreeWind::WindFieldPtr _winds[2];
};
