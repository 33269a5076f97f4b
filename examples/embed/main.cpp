// SPDX-License-Identifier: MIT
// A simulator in under 100 lines: a small wood, and a vortex worked out in a thread of its own.
// Usage: osgtreewind-embed [--frames N]     (without it: until escape is pressed)
#include <osgTreeWind/drawing/BranchTransform.h>
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/StreamedWind.h>

#include <osg/ArgumentParser>
#include <osg/ShapeDrawable>
#include <osgGA/TrackballManipulator>
#include <osgViewer/Viewer>

#include <atomic>
#include <chrono>
#include <cmath>
#include <iostream>
#include <thread>

using namespace osgTreeWind;

namespace {

/// Nine young maples, 8 m apart: what a .treewind file would say.
ForestDescription describeForest() {
    ForestDescription description;
    description.species = {*findSpecies("red maple")};
    for (int i = 0; i < 9; ++i) {
        TreePlacement tree;
        tree.position = 8.0 * glm::dvec3(i % 3 - 1, i / 3 - 1, 0);
        tree.heading = 0.7f * static_cast<float>(i);
        tree.size.height = 7.0f + static_cast<float>(i % 4);
        tree.seed = static_cast<std::uint32_t>(i);
        description.trees.push_back(tree);
    }
    return description;
}

/// The simulator's own wind: here a vortex in a breeze, on a grid of 32 x 32 points.
GridWind::Grid simulateWind(double time) {
    constexpr int size = 32;
    GridWind::Grid grid;
    grid.points = {size, size, 1};
    grid.origin = {-16.0, -16.0, 0.0};
    const glm::dvec2 vortex(10.0 * std::cos(0.4 * time), 10.0 * std::sin(0.4 * time));
    for (int i = 0; i < size * size; ++i) {
        const glm::dvec2 from = glm::dvec2(grid.origin) + glm::dvec2(i % size, i / size) - vortex;
        const double turn = 30.0 / (9.0 + from.x * from.x + from.y * from.y); // 1/s
        for (const double component : {3.0 - turn * from.y, turn * from.x, 0.0})
            grid.values.push_back(static_cast<float>(component));
    }
    return grid;
}

/// A new wind sixty times a second.
void streamWind(StreamedWind& wind, const std::atomic<bool>& done) {
    for (double time = 0.0; !done; time += 1.0 / 60.0) {
        wind.update({simulateWind(time).values}); // gives what is wrong with them: nothing
        std::this_thread::sleep_for(std::chrono::microseconds(16667));
    }
}

/// Hangs a red ball on a branch: it goes where the branch goes.
void markBranch(Forest& forest, TreeId tree, unsigned unit) {
    BranchTransform* branch = forest.branch(tree, unit);
    osg::ref_ptr<osg::ShapeDrawable> ball = new osg::ShapeDrawable(new osg::Sphere(branch->getBase(), 0.15f));
    ball->setColor(osg::Vec4(0.9f, 0.1f, 0.1f, 1.0f));
    branch->addChild(ball);
}

} // namespace

int main(int argc, char** argv) {
    unsigned frames = 0;
    osg::ArgumentParser(&argc, argv).read("--frames", frames);
    osg::ref_ptr<Forest> forest = new Forest(describeForest());
    markBranch(*forest, TreeId(4), 60); // trees of the description have their numbers for ids
    const auto wind = StreamedWind::create(simulateWind(0.0));
    if (!wind) {
        for (const Diagnostic& problem : wind.problems())
            std::cerr << problem.text() << '\n';
        return 1;
    }
    forest->setWind(wind.value());
    osgViewer::Viewer viewer;
    viewer.setSceneData(forest);
    viewer.setCameraManipulator(new osgGA::TrackballManipulator);
    viewer.setUpViewInWindow(50, 50, 640, 360);
    viewer.realize();
    if (!viewer.isRealized())
        return 1; // no window, as OSG has said
    std::atomic<bool> done{false};
    std::thread simulator([&] { streamWind(*wind.value(), done); });
    while (!viewer.done() && (frames == 0 || viewer.getFrameStamp()->getFrameNumber() < frames))
        viewer.frame();
    done = true;
    simulator.join();
    std::cout << forest->getNumTrees() << " trees, " << viewer.getFrameStamp()->getFrameNumber()
              << " frames\n";
}
