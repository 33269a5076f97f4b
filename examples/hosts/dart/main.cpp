// SPDX-License-Identifier: MIT
// A box in a DART world, and trees in a wind from the world. Usage: windy-world FILE.treewind
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/StreamedWind.h>

#include <dart/dart.hpp>
#include <dart/gui/osg/osg.hpp>

#include <osgDB/ReadFile>

#include <iostream>

/// Prints why a wind was refused; here, none is.
static void report(const osgTreeWind::Diagnostics& problems) {
    std::cerr << osgTreeWind::toString(problems);
}

/// A world node that updates the wind after each simulation step.
class WindyWorld : public dart::gui::osg::WorldNode {
public:
    WindyWorld(dart::simulation::WorldPtr world, osgTreeWind::StreamedWind& wind)
        : WorldNode(world), _wind(wind) {}
    void customPostStep() override { // a uniform westerly of varying speed
        const float speed = 8.0f + 6.0f * static_cast<float>(std::sin(getWorld()->getTime()));
        report(_wind.update({std::vector<float>{speed, 0.0f, 0.0f}}));
    }

private:
    osgTreeWind::StreamedWind& _wind;
};

int main(int, char** arguments) {
    const auto box = dart::dynamics::Skeleton::create("box");
    const auto body = box->createJointAndBodyNodePair<dart::dynamics::FreeJoint>().second;
    body->createShapeNodeWith<dart::dynamics::VisualAspect>(
        std::make_shared<dart::dynamics::BoxShape>(Eigen::Vector3d(1.0, 1.0, 2.0))); // metres
    box->setPositions((Eigen::Vector6d() << 0.0, 0.0, 0.0, 5.0, -4.0, 1.0).finished());
    const auto world = dart::simulation::World::create();
    world->setGravity(Eigen::Vector3d::Zero());
    world->addSkeleton(box);

    osgTreeWind::GridWind::Grid grid;
    grid.points = {1, 1, 1};
    grid.values = {0.0f, 0.0f, 0.0f};
    const auto wind = osgTreeWind::StreamedWind::create(grid).value();
    osg::ref_ptr<WindyWorld> node = new WindyWorld(world, *wind);
    osg::ref_ptr<osg::Node> trees = osgDB::readRefNodeFile(arguments[1]);
    if (!trees)
        return 1;
    if (auto* forest = dynamic_cast<osgTreeWind::Forest*>(trees.get()))
        report(forest->setWind(wind));
    node->addChild(trees);

    osg::ref_ptr<dart::gui::osg::Viewer> viewer = new dart::gui::osg::Viewer;
    viewer->addWorldNode(node);
    node->simulate(true);
    viewer->setUpViewInWindow(0, 0, 960, 600);
    viewer->getCameraManipulator()->setHomePosition({8.0, -42.0, 8.0}, {8.0, 0.0, 7.0}, {0.0, 0.0, 1.0});
    viewer->setCameraManipulator(viewer->getCameraManipulator());
    return viewer->run();
}
