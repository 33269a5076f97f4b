// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <iostream>

/// Makes a tree in a wind and simulates it. Succeeds if the tree moves.
int main() {
    osgTreeWind::ForestDescription description;
    description.species = {osgTreeWind::defaultSpecies()};
    description.trees.resize(1);
    description.wind = std::make_shared<osgTreeWind::UniformWind>(glm::vec3(8.0f, 0.0f, 0.0f));
    const osg::ref_ptr<osgTreeWind::Forest> forest = new osgTreeWind::Forest(description);

    osgTreeWind::ForestSimulation simulation(description);
    for (int frame = 0; frame <= 60; ++frame)
        simulation.advance(frame / 60.0);
    const osgTreeWind::TreeMotion motion = simulation.motion(osgTreeWind::TreeId(0));
    const float halfAngle = motion.rotations[0].y; // the trunk bends downwind
    std::cout << forest->getNumTrees() << " tree, half its rotation " << halfAngle << " rad\n";
    return forest->getNumTrees() == 1 && halfAngle > 0.0f ? 0 : 1;
}
