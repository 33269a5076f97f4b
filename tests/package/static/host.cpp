// SPDX-License-Identifier: MIT
// Reads and writes forests with the plugins linked statically. Usage: host PLAIN WEATHER COPY      PLAIN and
// WEATHER are .treewind files of one tree. WEATHER has a ground of 7 m from a raster, and a wind of 6 m/s
// toward +x from a GRIB file. COPY ends in .osgt.
#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/motion/damage/TreeSway.h>
#include <osgTreeWind/nodes/Forest.h>

#include <osgDB/ReadFile>
#include <osgDB/Registry>
#include <osgDB/WriteFile>
#include <osgUtil/UpdateVisitor>

#include <cmath>
#include <iostream>

USE_OSGPLUGIN(treewind)
USE_SERIALIZER_WRAPPER_LIBRARY(osgtreewind)

static osg::ref_ptr<osgTreeWind::Forest> readForest(const std::string& file) {
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(file);
    osg::ref_ptr<osgTreeWind::Forest> forest = dynamic_cast<osgTreeWind::Forest*>(node.get());
    if (!forest || forest->getNumTrees() != 1) {
        std::cerr << file << ": expected a forest of one tree\n";
        std::exit(1);
    }
    return forest;
}

int main(int, char** arguments) {
    const osg::ref_ptr<osgTreeWind::Forest> plain = readForest(arguments[1]);
    if (!osgDB::writeNodeFile(*plain, arguments[3]))
        return 1;
    readForest(arguments[3]);

    const osg::ref_ptr<osgTreeWind::Forest> forest = readForest(arguments[2]);
    osgUtil::UpdateVisitor update;
    const osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    update.setFrameStamp(stamp);
    for (unsigned frame = 0; frame < 60; ++frame) {
        stamp->setFrameNumber(frame);
        stamp->setSimulationTime(frame / 60.0);
        update.setTraversalNumber(frame);
        forest->accept(update);
    }
    const osgTreeWind::TreeId tree = forest->getTrees().front();
    const double height = forest->getPlacement(tree)->position.z;
    const float wind = forest->sway(tree)->windAtTop.x;
    std::cout << "ground " << height << " m, wind " << wind << " m/s\n";
    return std::abs(height - 7.0) < 1e-3 && std::abs(wind - 6.0f) < 0.1f ? 0 : 1;
}
