// SPDX-License-Identifier: MIT
// Runs the C++ of README.md beside a file forest.treewind.
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/StreamedWind.h>

#include <iostream>

static std::size_t reported = 0;

static void report(const osgTreeWind::Diagnostics& problems) {
    for (const osgTreeWind::Diagnostic& problem : problems)
        std::cout << problem.text() << '\n';
    reported += problems.size();
}

static void embed(osg::Group* scene, const osgTreeWind::GridWind::Grid& grid,
                  const std::vector<float>& velocities) {
#include "readme.inc"
}

/// Whether the forest stands in the scene, in this wind.
static bool moves(const osg::Group& scene, const glm::vec3& velocity) {
    const auto* forest =
        scene.getNumChildren() == 1 ? dynamic_cast<const osgTreeWind::Forest*>(scene.getChild(0)) : nullptr;
    if (!forest || forest->getNumTrees() == 0 || forest->getWind().isCalm())
        return false;
    return asField(forest->getWind())->velocity({}, 0.0) == velocity;
}

int main() {
    osgTreeWind::GridWind::Grid grid;
    grid.points = {2, 1, 1};
    grid.values = std::vector<float>(6, 1.0f);

    osg::ref_ptr<osg::Group> scene = new osg::Group;
    embed(scene, grid, std::vector<float>(6, 3.0f));
    if (reported != 0 || !moves(*scene, glm::vec3(3.0f))) {
        std::cout << "readme: the forest does not move in the wind of the last update\n";
        return 1;
    }
    scene = new osg::Group;
    embed(scene, grid, std::vector<float>(5, 3.0f));
    if (reported != 1 || !moves(*scene, glm::vec3(1.0f))) {
        std::cout << "readme: an update of the wrong size is not reported, or changes the wind\n";
        return 1;
    }
    scene = new osg::Group;
    grid.points = {3, 1, 1};
    embed(scene, grid, {});
    if (reported != 2) {
        std::cout << "readme: a grid of the wrong size is not reported\n";
        return 1;
    }
}
