// SPDX-License-Identifier: MIT
#pragma once

#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/nodes/Forest.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgDB/DatabasePager>

#include <gtest/gtest.h>

#include <chrono>
#include <set>
#include <string>
#include <thread>
#include <utility>

constexpr int settleFrames = 100; // to load near tiles and unload far ones

namespace osgTreeWind {

/// A cull visitor at a place, for TilePager.
class EyeVisitor : public osg::NodeVisitor {
public:
    explicit EyeVisitor(const osg::Vec3& place)
        : osg::NodeVisitor(CULL_VISITOR, TRAVERSE_ACTIVE_CHILDREN), _place(place) {}
    osg::Vec3 getEyePoint() const override { return _place; }
    osg::Vec3 getViewPoint() const override { return _place; }

private:
    osg::Vec3 _place;
};

/// A forest of 10 x 10 tiles of 100 m with nine trees each; tiles within 100 m are loaded.
class TiledWorld {
public:
    /// @param height of the smallest trees, metres.
    explicit TiledWorld(ForestDescription forest = smallForest(0), float height = 4.0f) {
        for (int x = 0; x < 30; ++x)
            for (int y = 0; y < 30; ++y) {
                TreePlacement tree;
                tree.position = {100.0 / 3.0 * (x + 0.5), 100.0 / 3.0 * (y + 0.5), 0.0};
                tree.size.height = height + 0.1f * static_cast<float>(x);
                tree.seed = static_cast<std::uint32_t>(30 * x + y);
                tree.name = std::to_string(x) + '/' + std::to_string(y);
                forest.trees.push_back(tree);
            }
        TilingOptions options;
        options.size = 100.0;
        options.range = 100.0;
        EXPECT_TRUE(writeTiledForest(forest, _folder.path(), options));
        Result<ForestFile> world = readForestFile(_folder.path() + "/world.treewind");
        EXPECT_TRUE(world);
        _forest = new Forest(std::move(world.value()));
        _pager->setTargetMaximumNumberOfPageLOD(0);
    }
    ~TiledWorld() { _pager->cancel(); }

    Forest& forest() { return *_forest; }
    /// Loads the tiles from a URL from now on.
    void readFrom(const std::string& url) {
        Result<ForestFile> world = readForestFile(_folder.path() + "/world.treewind");
        world.value().tiles->folder = url;
        EXPECT_TRUE(_forest->setDescription(std::move(world.value())).empty());
    }
    const TemporaryFolder& folder() const { return _folder; }
    std::string tile(const std::string& name) const { return _folder.path() + "/tiles/" + name + ".trees"; }

    /// Runs frames of 0.1 s, with pauses for the thread of the pager.
    void frames(const osg::Vec3& eye, int count) { frames(*_forest, eye, count); }
    void frames(Forest& forest, const osg::Vec3& eye, int count) {
        for (int i = 0; i < count; ++i) {
            osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
            stamp->setFrameNumber(++_frame);
            stamp->setSimulationTime(0.1 * _frame);
            stamp->setReferenceTime(0.1 * _frame);
            _pager->signalBeginFrame(stamp);
            _pager->updateSceneGraph(*stamp);
            osgUtil::UpdateVisitor update;
            update.setFrameStamp(stamp);
            forest.accept(update);
            EyeVisitor cull(eye);
            cull.setFrameStamp(stamp);
            cull.setDatabaseRequestHandler(_pager);
            forest.accept(cull);
            _pager->signalEndFrame();
            std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
    }

    /// A place 2 m above the ground in the forest's frame. @param x, y world coordinates.
    osg::Vec3 at(double x, double y) const { return osg::Vec3d(x, y, 2.0) - _forest->getOrigin(); }

    std::set<std::string> names() const { return namesOf(*_forest); }
    static std::set<std::string> namesOf(const Forest& forest) {
        std::set<std::string> names;
        for (const TreeId tree : forest.getTrees())
            names.insert(forest.getPlacement(tree)->name);
        return names;
    }

private:
    TemporaryFolder _folder;
    osg::ref_ptr<osgDB::DatabasePager> _pager = osgDB::DatabasePager::create();
    osg::ref_ptr<Forest> _forest;
    unsigned _frame = 0;
};

} // namespace osgTreeWind
