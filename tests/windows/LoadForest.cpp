// SPDX-License-Identifier: MIT
// An OSG program without osgTreeWind, which loads a forest by the plugin. Usage: load_forest FILE.treewind
#include <osgDB/ReadFile>

#include <iostream>

int main(int, char** arguments) {
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(arguments[1]);
    if (!node)
        return 1;
    std::cout << node->libraryName() << "::" << node->className() << " of radius "
              << node->getBound().radius() << std::endl;
    return node->getBound().valid() ? 0 : 1;
}
