// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <cmath>
#include <iostream>

/// A tree made in code, in a wind: succeeds when it has moved.
int main() {
    osgTreeWind::ForestDescription description;
    description.species = {osgTreeWind::defaultSpecies()};
    description.trees.resize(1);
    description.wind = std::make_shared<osgTreeWind::UniformWind>(glm::vec3(8.0f, 0.0f, 0.0f));
    const osg::ref_ptr<osgTreeWind::Forest> forest = new osgTreeWind::Forest(description);

    osgTreeWind::ForestSimulation simulation(description);
    for (int frame = 0; frame <= 60; ++frame)
        simulation.advance(frame / 60.0);
    const osgTreeWind::TreeMotion motion = simulation.motion(0);
    const float turned = motion.rotations[0].w; // the trunk; 1 at rest
    std::cout << forest->getNumTrees() << " tree, its trunk is turned by " << 2.0f * std::acos(turned)
              << '\n';
    return forest->getNumTrees() == 1 && turned < 1.0f ? 0 : 1;
}
