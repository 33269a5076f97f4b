// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/drawing/branchwise/BranchwiseForest.h>
#include <osgTreeWind/drawing/branchwise/TreeNode.h>
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <osg/Camera>

#include <osg/FrameStamp>
#include <osgUtil/UpdateVisitor>

#include <memory>
#include <random>

/// A species with few branches, for quick drawing by llvmpipe: 2 units of trunk, then 3, then 9.
inline osgTreeWind::Species smallSpecies() {
    osgTreeWind::Species species;
    species.name = "small";
    species.tree.wood.levels = 2;
    species.wood.elasticModulus = 5.0e8f; // soft, for visible motion
    species.shapes = 2;
    return species;
}

/// `count` small trees of different size and heading, in rows of four 3 m apart, in a wind toward +x.
inline osgTreeWind::ForestDescription smallForest(int count, float speed = 10.0f) {
    osgTreeWind::ForestDescription description;
    description.species = {smallSpecies()};
    for (int i = 0; i < count; ++i) {
        osgTreeWind::TreePlacement tree;
        tree.position = {3.0 * (i % 4), 3.0 * (i / 4), 0.0};
        tree.heading = 0.7f * static_cast<float>(i);
        tree.size.height = 5.0f + 0.5f * static_cast<float>(i);
        tree.size.crownWidth = 4.0f;
        tree.seed = static_cast<std::uint32_t>(i);
        description.trees.push_back(tree);
    }
    description.wind = std::make_shared<osgTreeWind::UniformWind>(glm::vec3(speed, 0.0f, 0.0f));
    return description;
}

/// Looks at the two rows of smallForest(8) from the south, for pictures of aspect ratio 4:3.
inline void lookAtSmallForest(osg::Camera& camera) {
    camera.setClearColor(osg::Vec4(0, 0, 0, 1));
    camera.setProjectionMatrixAsPerspective(40, 4.0 / 3.0, 1, 100);
    camera.setViewMatrixAsLookAt(osg::Vec3(4.5f, -14, 4), osg::Vec3(4.5f, 0, 3), osg::Z_AXIS);
}

/// One tree of the given species, unscaled, at the origin.
inline osgTreeWind::ForestDescription oneTree(const osgTreeWind::Species& species, float speed = 10.0f) {
    osgTreeWind::ForestDescription description = smallForest(1, speed);
    description.species = {species};
    description.trees = {osgTreeWind::TreePlacement()};
    description.trees.front().openGrown = true;
    return description;
}

/// TreeMotion::states of all units of all trees.
inline std::vector<glm::vec4> statesOf(const osgTreeWind::Forest& forest) {
    std::vector<glm::vec4> states;
    for (std::size_t tree = 0; tree < osgTreeWind::movingForest(forest.getSimulation()).trees().size();
         ++tree)
        for (const glm::vec4& state : movingForest(forest.getSimulation()).motion(tree).states)
            states.push_back(state);
    return states;
}

/// TreeMotion::winds of all units of all trees.
inline std::vector<glm::vec3> windsOf(const osgTreeWind::Forest& forest) {
    std::vector<glm::vec3> winds;
    for (std::size_t tree = 0; tree < osgTreeWind::movingForest(forest.getSimulation()).trees().size();
         ++tree)
        for (const glm::vec3& wind : movingForest(forest.getSimulation()).motion(tree).winds)
            winds.push_back(wind);
    return winds;
}

/// Runs the update traversal of one frame.
inline void update(osg::Node& scene, unsigned frame, double time) {
    osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    stamp->setFrameNumber(frame);
    stamp->setSimulationTime(time);
    osgUtil::UpdateVisitor visitor;
    visitor.setFrameStamp(stamp);
    visitor.setTraversalNumber(frame);
    scene.accept(visitor);
}

/// Runs the update traversals of frames `first` to `last`, 1/25 s apart.
inline void updateFrames(osg::Node& scene, unsigned first, unsigned last) {
    for (unsigned frame = first; frame <= last; ++frame)
        update(scene, frame, frame / 25.0);
}

inline osg::Matrix worldMatrix(osg::Node& node) {
    return osg::computeLocalToWorld(node.getParentalNodePaths().at(0));
}

inline osg::Quat randomTurn(std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
    osg::Vec3d axis(anywhere(random), anywhere(random), anywhere(random) + 1.5);
    return osg::Quat(3.0 * anywhere(random), axis / axis.length());
}
