// SPDX-License-Identifier: MIT
#include <osgTreeWind/nodes/ForestStatistics.h>

#include <osgTreeWind/drawing/stand/DrawnTrees.h>
#include <osgTreeWind/drawing/stand/StandDrawing.h>
#include <osgTreeWind/drawing/stand/StandParts.h>
#include <osgTreeWind/drawing/stand/TreeStand.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/nodes/TilePager.h>

#include <osg/Stats>
#include <osg/View>
#include <osgUtil/CullVisitor>

#include <cstdint>
#include <fstream>
#include <unistd.h>

namespace osgTreeWind {

namespace {

/// Bytes that the process has in memory.
double residentBytes() {
    std::uint64_t all = 0, pages = 0;
    std::ifstream("/proc/self/statm") >> all >> pages;
    return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

} // namespace

void reportStatistics(Forest& forest, osg::NodeVisitor& cullVisitor, double step, double cull,
                      const TilePager* tiles) {
    osgUtil::CullVisitor* visitor = cullVisitor.asCullVisitor();
    osg::Camera* camera = visitor ? visitor->getCurrentCamera() : nullptr;
    osg::Stats* stats = camera && camera->getView() ? camera->getView()->getStats() : nullptr;
    if (!stats || !stats->collectStats("update"))
        return;
    const unsigned frame = cullVisitor.getFrameStamp()->getFrameNumber();
    stats->setAttribute(frame, "Forest step", step);
    stats->setAttribute(frame, "Forest cull", cull);
    stats->setAttribute(frame, "Forest trees", static_cast<double>(forest.getNumTrees()));
    stats->setAttribute(frame, "Process memory", residentBytes());
    if (tiles)
        stats->setAttribute(frame, "Forest tiles", static_cast<double>(tiles->countThere()));
    if (!forest.getStand())
        return;
    const DrawnTrees drawn(StandParts::trees(*forest.getStand())->listedTrees());
    stats->setAttribute(frame, "Forest trees in full", static_cast<double>(drawn.full));
    stats->setAttribute(frame, "Forest trees by boughs", static_cast<double>(drawn.byBoughs));
    stats->setAttribute(frame, "Forest trees as pictures", static_cast<double>(drawn.asPictures));
}

} // namespace osgTreeWind
