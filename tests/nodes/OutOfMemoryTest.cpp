// SPDX-License-Identifier: MIT
// Single allocations fail: the host survives.
#include <osgTreeWind/drawing/instanced/InstancedForest.h>
#include <osgTreeWind/drawing/instanced/InstancedTrees.h>
#include <tests/MessageCollector.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/Culling.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/plugins/PluginPath.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

constexpr long noFailure = -1;
std::atomic<long> allocationsLeft{noFailure};

/// Makes one allocation by operator new fail during its lifetime, in any thread.
class FailingMemory {
public:
    /// @param allocations that succeed before the failure.
    explicit FailingMemory(long allocations) { allocationsLeft = allocations; }
    ~FailingMemory() { allocationsLeft = noFailure; }
    FailingMemory(const FailingMemory&) = delete;
    FailingMemory& operator=(const FailingMemory&) = delete;

    static bool hasFailed() { return allocationsLeft < 0; }
};

} // namespace

// Not inlined: GCC would report new and free() as mismatched. All forms of new and delete are replaced, as
// AddressSanitizer requires.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    if (allocationsLeft >= 0 && allocationsLeft-- == 0)
        return nullptr;
    return std::malloc(size > 0 ? size : 1);
}

[[gnu::noinline]] void* operator new(std::size_t size) {
    if (void* memory = operator new(size, std::nothrow))
        return memory;
    throw std::bad_alloc();
}

[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}

[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace osgTreeWind;

namespace {

class OutOfMemoryTest : public testing::Test {
protected:
    /// Repeats an entry point, each time with a later failure, until no allocation fails.
    /// @return the number of failures.
    template <typename Entry>
    int failLaterEachTime(const Entry& entry) {
        int times = 0;
        for (long allocations = 0;; allocations += 1 + allocations / 12, ++times)
            if (!entry(allocations))
                return times;
    }

    const ScopedMessages messages;
};

constexpr const char* smallFile = "version = 1\n"
                                  "[[species]]\n"
                                  "name = \"small\"\n"
                                  "[species.tree]\n"
                                  "levels = 2\n"
                                  "[[tree]]\n"
                                  "position = [1.0, 2.0]\n";

} // namespace

TEST_F(OutOfMemoryTest, AFailedReadIsAProblem) {
    usePluginsOfThisBuild();
    const TemporaryFolder folder;
    const std::string path = folder.write("small.treewind", smallFile);
    const osgDB::ReaderWriter* reader = osgDB::Registry::instance()->getReaderWriterForExtension("treewind");
    ASSERT_NE(reader, nullptr);
    const int times = failLaterEachTime([&](long allocations) {
        osgDB::ReaderWriter::ReadResult result;
        bool failed = false;
        {
            const FailingMemory failing(allocations);
            result = reader->readNode(path, nullptr);
            failed = FailingMemory::hasFailed();
        }
        EXPECT_TRUE(result.success() || !result.message().empty()) << allocations;
        EXPECT_TRUE(failed || result.success()) << result.message();
        return failed;
    });
    EXPECT_GT(times, 50);
    EXPECT_TRUE(reader->readNode(path, nullptr).success());
}

TEST_F(OutOfMemoryTest, AFailedUpdateStopsTheForest) {
    osg::ref_ptr<Forest> forest = new Forest;
    int stopped = 0;
    const int times = failLaterEachTime([&](long allocations) {
        EXPECT_TRUE(forest->setDescription(smallForest(4)).empty());
        osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
        osgUtil::UpdateVisitor visitor;
        visitor.setFrameStamp(stamp);
        visitor.getNodePath().reserve(64); // OSG's own
        visitor.pushOntoNodePath(forest);
        const auto update = [&](unsigned frame) {
            stamp->setFrameNumber(frame);
            stamp->setSimulationTime(frame / 25.0);
            forest->traverse(visitor);
        };
        bool failed = false;
        {
            const FailingMemory failing(allocations);
            for (unsigned frame = 1; frame <= 3; ++frame)
                update(frame);
            failed = FailingMemory::hasFailed();
        }
        const std::vector<glm::vec4> before = statesOf(*forest);
        update(4);
        stopped += statesOf(*forest) == before;
        const std::string warnings = messages.take();
        EXPECT_LE(std::count(warnings.begin(), warnings.end(), '\n'), 1) << warnings;
        return failed;
    });
    EXPECT_GT(times, 10);
    EXPECT_GT(stopped, 0);
    EXPECT_TRUE(forest->setDescription(smallForest(4)).empty());
    updateFrames(*forest, 1, 20);
    const std::vector<glm::vec4> before = statesOf(*forest);
    updateFrames(*forest, 21, 25);
    EXPECT_NE(statesOf(*forest), before) << "it moves again";
}

TEST_F(OutOfMemoryTest, AFailedCullRestoresItsVisitor) {
    osg::ref_ptr<Forest> forest = new Forest(smallForest(8));
    updateFrames(*forest, 1, 2);
    InstancedTrees* const trees = &instancedTrees(*forest->getInstanced());
    osg::ref_ptr<osgUtil::CullVisitor> visitor = new osgUtil::CullVisitor;
    osg::ref_ptr<osg::FrameStamp> stamp = new osg::FrameStamp;
    visitor->setFrameStamp(stamp);
    visitor->setStateGraph(new osgUtil::StateGraph);
    osg::ref_ptr<osgUtil::RenderStage> stage = new osgUtil::RenderStage;
    stage->setViewport(new osg::Viewport(0, 0, 64, 64));
    visitor->setRenderStage(stage);
    visitor->pushViewport(stage->getViewport());
    visitor->pushProjectionMatrix(new osg::RefMatrix(osg::Matrix::perspective(60, 1, 1, 1e5)));
    visitor->pushModelViewMatrix(
        new osg::RefMatrix(osg::Matrix::lookAt(osg::Vec3d(5, -30, 5), osg::Vec3d(), osg::Vec3d(0, 0, 1))),
        osg::Transform::ABSOLUTE_RF);
    visitor->getNodePath().reserve(64); // OSG's own
    const osgUtil::StateGraph* place = visitor->getCurrentStateGraph();
    const int times = failLaterEachTime([&](long allocations) {
        stamp->setFrameNumber(static_cast<unsigned>(allocations) + 3);
        bool failed = false;
        {
            const FailingMemory failing(allocations);
            trees->accept(*visitor);
            failed = FailingMemory::hasFailed();
        }
        EXPECT_EQ(visitor->getCurrentStateGraph(), place) << allocations;
        EXPECT_TRUE(visitor->getNodePath().empty());
        return failed;
    });
    EXPECT_GT(times, 5);
    const std::string warnings = messages.take(); // OSG may add that a buffer lacks an array
    const std::string ours = "osgTreeWind: out of memory; trees of the forest may be missing in pictures\n";
    EXPECT_NE(warnings.find(ours), std::string::npos) << warnings;
    EXPECT_EQ(warnings.find("osgTreeWind"), warnings.rfind("osgTreeWind")) << warnings;
}
