// SPDX-License-Identifier: MIT
// A tree leans to where the wind of an OpenSCENARIO blows to, with the code of examples/hosts/esmini, also
// below a transform that turns it. Usage: esmini_wind FILE.treewind
#include <osgTreeWind/motion/damage/TreeSway.h>
#include <osgTreeWind/nodes/Forest.h>

#include <osg/MatrixTransform>
#include <osgDB/ReadFile>
#include <osgUtil/UpdateVisitor>

#include <cmath>
#include <iostream>

void setTreeWind(osg::Node& scene, double direction, double speed);

int main(int, char** arguments) {
    const double heading = 1.0;
    const osg::ref_ptr<osg::MatrixTransform> scene =
        new osg::MatrixTransform(osg::Matrix::rotate(heading, 0.0, 0.0, 1.0));
    const osg::ref_ptr<osg::Node> node = osgDB::readRefNodeFile(arguments[1]);
    auto* const forest = dynamic_cast<osgTreeWind::Forest*>(node.get());
    if (!forest)
        return 1;
    scene->addChild(forest);
    osgUtil::UpdateVisitor update;
    const osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    update.setFrameStamp(stamp);
    unsigned frame = 0;
    for (const double direction : {0.0, 1.570796, 4.0}) { // radians counterclockwise from x
        setTreeWind(*scene, direction, 12.0);
        glm::dvec2 lean(0.0);
        for (unsigned last = frame + 3600; frame < last; ++frame) {
            stamp->setFrameNumber(frame);
            stamp->setSimulationTime(frame / 60.0);
            update.setTraversalNumber(frame);
            scene->accept(update);
            lean += glm::dvec2(forest->sway(forest->getTrees().front())->displacement);
        }
        const double off = std::remainder(std::atan2(lean.y, lean.x) + heading - direction, 2.0 * osg::PI);
        std::cout << "wind toward " << direction << " rad: the mean lean differs by " << off << " rad\n";
        if (std::abs(off) > 0.1)
            return 1;
    }
    return 0;
}
