// SPDX-License-Identifier: MIT
#include <examples/osgtreewind/bench/BenchReport.h>

#include <examples/osgtreewind/bench/BenchClock.h>
#include <examples/osgtreewind/pictures/OffscreenViewer.h>

#include <osgTreeWind/base/PortableMath.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/nodes/ForestStatistics.h>
#include <osgTreeWind/nodes/TilePager.h>
#include <osgTreeWind/system/Machine.h>
#include <osgTreeWind/system/Memory.h>

#include <cmath>
#include <fstream>

using namespace osgTreeWind;

namespace {

constexpr double speed = BenchWorld::speed, height = 80.0; // metres above the highest foot
constexpr int mostFramesToFirst = 1000;

TilePager* pagerOf(Forest& forest) {
    for (unsigned i = 0; i < forest.getNumChildren(); ++i)
        if (auto* pager = dynamic_cast<TilePager*>(forest.getChild(i)))
            return pager;
    return nullptr;
}

/// Flight along an ellipse around the middle of the world, half as long and wide as the world.
class Flight {
public:
    explicit Flight(const Forest& forest) {
        const ForestTiles& tiles = *forest.getDescription().tiles;
        const glm::dvec2 size = tiles.size * glm::dvec2(tiles.columns, tiles.rows());
        const osg::Vec3d origin = forest.getOrigin();
        _middle = {tiles.corner.x + 0.5 * size.x - origin.x(), tiles.corner.y + 0.5 * size.y - origin.y(),
                   forest.getBound().center().z() + height};
        _half = {0.25 * size.x, 0.25 * size.y};
    }
    osg::Matrixd view(double metres) const {
        const double angle = metres / std::sqrt(0.5 * (_half.x() * _half.x() + _half.y() * _half.y()));
        const osg::Vec3d eye = _middle +
                               osg::Vec3d(_half.x() * math::cos(angle), _half.y() * math::sin(angle), 0.0),
                         ahead(-_half.x() * math::sin(angle), _half.y() * math::cos(angle), 0.0);
        return osg::Matrixd::lookAt(eye, eye + ahead * (100.0 / ahead.length()) - osg::Vec3d(0.0, 0.0, 12.0),
                                    osg::Vec3d(0.0, 0.0, 1.0));
    }

private:
    osg::Vec3d _middle;
    osg::Vec2d _half;
};

/// Longest time for which something was missing without a break.
class LongestGap {
public:
    void update(double time, bool missing) {
        if (!missing)
            _since = time;
        _longest = std::max(_longest, time - _since);
    }
    double longest() const { return _longest; }

private:
    double _since = 0.0, _longest = 0.0;
};

} // namespace

BenchWorld runBenchWorld(const std::string& name, const ForestDescription& description,
                         const BenchSettings& settings, BenchDriver& driver) {
    BenchWorld result;
    result.forest = name;
    result.trees = description.tiles->treeCount();
    result.range = description.tiles->range;
    const double readBefore = bytesRead();
    const BenchClock clock;
    const osg::ref_ptr<Forest> forest = new Forest(description);
    const TilePager* pager = pagerOf(*forest);
    OffscreenViewer drawing(settings.size.width, settings.size.height, 1, settings.profile);
    osgViewer::Viewer& viewer = drawing.viewer();
    viewer.setSceneData(forest);
    osg::Camera& camera = *viewer.getCamera();
    camera.setProjectionMatrixAsPerspective(
        benchFieldOfView, static_cast<double>(settings.size.width) / settings.size.height, 1.0, 20000.0);
    const Flight flight(*forest);
    camera.setViewMatrix(flight.view(0.0));
    viewer.realize();
    drawing.frame(0.0);
    result.firstFrameSeconds = clock.seconds();
    camera.getGraphicsContext()->makeCurrent();
    driver.renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    camera.getGraphicsContext()->releaseContext();
    for (int i = 0; i < mostFramesToFirst && (pager->nearestMissingDistance() < result.range || i < 2); ++i)
        drawing.frame(clock.seconds());
    result.firstPictureSeconds = clock.seconds();

    const BenchClock flown;
    LongestGap missing;
    for (int i = 0; i < settings.frames; ++i) {
        camera.setViewMatrix(flight.view(speed * flown.seconds()));
        const BenchClock frame;
        drawing.frame(clock.seconds());
        result.frameMs.push_back(1000.0 * frame.seconds());
        missing.update(flown.seconds(), pager->nearestMissingDistance() < 0.5 * result.range);
        result.mostTrees = std::max(result.mostTrees, forest->getNumTrees());
        const double memory = residentBytes();
        result.mostBytes = std::max(result.mostBytes, memory);
        if (i == settings.frames / 2)
            result.halfwayBytes = memory;
    }
    result.endBytes = residentBytes();
    result.flownSeconds = flown.seconds();
    result.missingSeconds = missing.longest();
    result.bytesRead = bytesRead() - readBefore;
    return result;
}
