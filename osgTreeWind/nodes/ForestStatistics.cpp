// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/ForestStatistics.h>

#include <osgTreeWind/drawing/stand/StandDrawing.h>
#include <osgTreeWind/drawing/stand/TreeStand.h>
#include <osgTreeWind/nodes/Forest.h>

#include <osg/Stats>
#include <osg/View>
#include <osgUtil/CullVisitor>

#include <numeric>

namespace osgTreeWind {

void reportStatistics(Forest& forest, osg::NodeVisitor& cullVisitor, double step, double cull) {
    osgUtil::CullVisitor* visitor = cullVisitor.asCullVisitor();
    osg::Camera* camera = visitor ? visitor->getCurrentCamera() : nullptr;
    osg::Stats* stats = camera && camera->getView() ? camera->getView()->getStats() : nullptr;
    if (!stats || !stats->collectStats("update"))
        return;
    const unsigned frame = cullVisitor.getFrameStamp()->getFrameNumber();
    stats->setAttribute(frame, "Forest step", step);
    stats->setAttribute(frame, "Forest cull", cull);
    stats->setAttribute(frame, "Forest trees", static_cast<double>(forest.getNumTrees()));
    if (!forest.getStand())
        return;
    const auto listed = forest.getStand()->trees()->listedTrees();
    const auto full = listed.begin() + static_cast<std::size_t>(Tier::Full),
               pictures = listed.begin() + static_cast<std::size_t>(Tier::Impostor);
    stats->setAttribute(frame, "Forest trees in full", static_cast<double>(*full));
    stats->setAttribute(frame, "Forest trees by boughs", std::accumulate(full + 1, pictures, 0.0));
    stats->setAttribute(frame, "Forest trees as pictures", std::accumulate(pictures, listed.end(), 0.0));
}

} // namespace osgTreeWind
