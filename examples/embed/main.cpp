// SPDX-License-Identifier: MIT
// Minimal host: a lorry drives through a wood on hilly ground, with the wind of a simulator in its own
// thread. Usage: osgtreewind-embed [--frames N]
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/places/FunctionGround.h>
#include <osgTreeWind/wind/StreamedWind.h>

#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osgViewer/Viewer>

#include <atomic>
#include <chrono>
#include <cmath>
#include <iostream>
#include <string>
#include <thread>

using namespace osgTreeWind;

constexpr double laneRadius = 60.0, speed = 14.0, length = 12.0; // metres, m/s, metres

/// The simulator's terrain: the height at a place, metres.
static float groundHeight(double x, double y) {
    return static_cast<float>(2.0 * std::sin(0.05 * x) * std::cos(0.04 * y));
}

/// The pose of the lorry: x forward, z up, origin at the rear, on the lane.
static osg::Matrix lorryPose(double time) {
    const double angle = speed / laneRadius * time, x = laneRadius * std::cos(angle),
                 y = laneRadius * std::sin(angle);
    return osg::Matrix::rotate(angle + osg::PI_2, 0, 0, 1) * osg::Matrix::translate(x, y, groundHeight(x, y));
}

/// Birches on both sides of a circular road. A .treewind file could describe the same.
static ForestDescription describeForest() {
    ForestDescription description;
    description.ground = std::make_shared<FunctionGround>(groundHeight);
    description.species = {*findSpecies("silver birch")};
    for (unsigned i = 0; i < 180; ++i) {
        const osg::Vec3d place = osg::Vec3d(0, i % 2 ? 6.0 + i % 9 : -6.0 - i % 12, 0) * lorryPose(0.15 * i);
        TreePlacement& tree = description.trees.emplace_back();
        tree.position = {place.x(), place.y(), groundHeight(place.x(), place.y())};
        tree.size.height = 7.0f + static_cast<float>(i % 7);
        tree.seed = i;
    }
    return description;
}

/// The simulator's wind at 32 points, 6 m apart from west to east: gusts that travel through the wood.
static GridWind::Grid simulateWind(double time) {
    GridWind::Grid grid;
    grid.points = {32, 1, 1};
    grid.origin = {-96.0, 0.0, 0.0};
    grid.cell = {6.0, 1.0, 1.0};
    for (int i = 0; i < 32; ++i)
        grid.values.insert(grid.values.end(),
                           {4.0f + 3.0f * static_cast<float>(std::sin(0.6 * i - 0.5 * time)), 0.0f, 0.0f});
    return grid;
}

/// The airflow around the lorry.
static WindSource lorryFlow(double time) {
    const osg::Vec3d rear = lorryPose(time).getTrans(),
                     ahead = osg::Vec3d(speed, 0, 0) * lorryPose(time) - rear;
    WindSource flow;
    flow.velocity = {ahead.x(), ahead.y(), 0.0};
    flow.position = glm::dvec3(rear.x(), rear.y(), rear.z()) - time * flow.velocity; // at time 0
    flow.kind = WindSource::Kind::Vehicle, flow.radius = 1.25, flow.height = 4.0, flow.length = length;
    return flow;
}

/// Prints why a wind was refused; here, none is.
static void report(const Diagnostics& problems) {
    std::cerr << toString(problems);
}

static void add(osg::Group& group, osg::Shape* shape, const osg::Vec4& colour) {
    osg::ref_ptr<osg::ShapeDrawable> drawable = new osg::ShapeDrawable(shape);
    drawable->setColor(colour);
    group.addChild(drawable);
}

int main(int argc, char** argv) {
    unsigned long frames = argc > 2 ? std::stoul(argv[2]) : ~0ul;
    osg::ref_ptr<osg::HeightField> ground = new osg::HeightField;
    ground->allocate(100, 100);
    ground->setOrigin({-100, -100, 0});
    ground->setXInterval(2), ground->setYInterval(2);
    for (unsigned i = 0; i < 100 * 100; ++i)
        ground->setHeight(i % 100, i / 100, groundHeight(2.0 * (i % 100) - 100, 2.0 * (i / 100) - 100));
    osg::ref_ptr<osg::MatrixTransform> lorry = new osg::MatrixTransform;
    add(*lorry, new osg::Box({length / 2, 0, 2.2f}, length, 2.5f, 3.6f), {0.7f, 0.1f, 0.05f, 1.0f});
    osg::ref_ptr<Forest> forest = new Forest(describeForest());
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    add(*scene, ground, {0.2f, 0.26f, 0.1f, 1.0f});
    scene->addChild(lorry);
    scene->addChild(forest);
    osgViewer::Viewer viewer;
    viewer.setSceneData(scene);
    viewer.setLightingMode(osg::View::SKY_LIGHT);
    viewer.setUpViewInWindow(50, 50, 960, 540);
    viewer.realize();
    if (!viewer.isRealized())
        return 1; // no window; OSG has printed the reason
    const auto wind = StreamedWind::create(simulateWind(0.0)).value();
    std::atomic<bool> done{false};
    std::thread simulator([&] {
        for (double time = 0.0; !done; time += 1.0 / 60.0) { // 60 updates per second
            report(wind->update({simulateWind(time).values}));
            std::this_thread::sleep_for(std::chrono::microseconds(16667));
        }
    });
    for (; !viewer.done() && frames > 0; --frames) {
        const double time = viewer.elapsedTime();
        lorry->setMatrix(lorryPose(time));
        Wind now(wind);
        now.sources = {lorryFlow(time)};
        report(forest->setWind(now));
        const osg::Vec3d behind = osg::Vec3d(0, 0, 6) * lorryPose(time - 1.6),
                         front = lorry->getBound().center();
        viewer.getCamera()->setViewMatrixAsLookAt(behind, front, {0, 0, 1});
        viewer.frame(time);
    }
    done = true;
    simulator.join();
}
