// SPDX-License-Identifier: MIT
// A host with hundreds of forests and its own threads.
#include <tests/FullTests.h>
#include <tests/ProcessThreadCount.h>
#include <tests/nodes/Culling.h>
#include <tests/nodes/ForestFixtures.h>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

using namespace osgTreeWind;

namespace {

/// The update and cull traversals of one frame.
void showFrame(osg::Node& scene, unsigned frame) {
    update(scene, frame, frame / 25.0);
    cull(scene, frame, osg::Vec3d(5, -30, 5));
}

} // namespace

TEST(ManyForests, TwoViewersRunThemOnTheHostsThreads) {
    std::atomic<int> calls{0};
    const Executor host = [&](std::size_t count, const std::function<void(std::size_t)>& job) {
        ++calls;
        for (std::size_t i = 0; i < count; ++i)
            job(i);
    };
    std::vector<osg::ref_ptr<Forest>> forests;
    osg::ref_ptr<osg::Group> scenes[] = {new osg::Group, new osg::Group};
    const int count = casesToRun(200, 60);
    for (int i = 0; i < count; ++i) {
        Result<osg::ref_ptr<Forest>> made = Forest::create(smallForest(9), host);
        ASSERT_TRUE(made);
        forests.push_back(made.value());
        scenes[i % 2]->addChild(made.value());
    }
    std::thread([] {}).join(); // a sanitizer starts its own thread with the first one
    const std::ptrdiff_t threads = processThreadCount();
    std::vector<std::thread> viewers;
    for (const osg::ref_ptr<osg::Group>& scene : scenes)
        viewers.emplace_back([&] {
            for (unsigned frame = 1; frame <= 5; ++frame)
                showFrame(*scene, frame);
        });
    for (std::thread& viewer : viewers)
        viewer.join();
    EXPECT_EQ(processThreadCount(), threads);
    EXPECT_GE(calls, count * 4) << "every step of every forest";
    for (const osg::ref_ptr<Forest>& forest : forests)
        ASSERT_EQ(statesOf(*forest), statesOf(*forests.front()));
}
