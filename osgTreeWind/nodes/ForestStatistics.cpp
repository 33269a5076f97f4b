// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/ForestStatistics.h>

#include <osgTreeWind/system/Memory.h>

#include <osg/View>
#include <osgUtil/CullVisitor>

namespace osgTreeWind {

osg::Stats* viewStatistics(osg::NodeVisitor& cullVisitor) {
    osgUtil::CullVisitor* visitor = cullVisitor.asCullVisitor();
    osg::Camera* camera = visitor ? visitor->getCurrentCamera() : nullptr;
    osg::Stats* stats = camera && camera->getView() ? camera->getView()->getStats() : nullptr;
    return stats && stats->collectStats("update") ? stats : nullptr;
}

void ForestStatistics::report(osg::Stats& stats, unsigned frame) const {
    stats.setAttribute(frame, "Forest step", step);
    stats.setAttribute(frame, "Forest cull", cull);
    stats.setAttribute(frame, "Forest trees", static_cast<double>(trees));
    stats.setAttribute(frame, "Process memory", residentBytes());
    if (tiles)
        stats.setAttribute(frame, "Forest tiles", static_cast<double>(*tiles));
    if (!drawn)
        return;
    stats.setAttribute(frame, "Forest trees in full", static_cast<double>(drawn->full));
    stats.setAttribute(frame, "Forest trees by boughs", static_cast<double>(drawn->byBoughs));
    stats.setAttribute(frame, "Forest trees as pictures", static_cast<double>(drawn->asPictures));
}

} // namespace osgTreeWind
