// SPDX-License-Identifier: MIT
// Memory per tree, as counted by the allocator.
#include <osgTreeWind/base/Random.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MemoryEstimate.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>

#include <malloc.h>

namespace osgTreeWind {
namespace {

#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 33)

std::size_t bytesInUse() {
    const struct mallinfo2 info = mallinfo2();
    return info.uordblks + info.hblkhd;
}

bool allocatorReportsUse() {
    const std::size_t before = bytesInUse();
    constexpr std::size_t size = 1 << 20;
    void* const volatile block = std::malloc(size); // volatile, or clang would remove it
    const bool tells = bytesInUse() >= before + size;
    std::free(block);
    return tells;
}

std::unique_ptr<ForestSimulation> mixedWood(std::size_t count, ModalLevel level = ModalLevel::Far) {
    ForestDescription forest;
    forest.species = {*findSpecies("oak"), *findSpecies("Norway spruce")};
    forest.wind = std::make_shared<UniformWind>(glm::vec3(7, 0, 0));
    Random random(1);
    for (std::size_t i = 0; i < count; ++i) {
        TreePlacement tree;
        tree.species = random.next() % 2;
        tree.position = {3000.0f * random.uniform(), 3000.0f * random.uniform(), 0.0f};
        tree.size.height = 8.0f + 18.0f * random.uniform();
        tree.seed = static_cast<std::uint32_t>(i);
        forest.trees.push_back(tree);
    }
    SimulationOptions options;
    options.distant = level == ModalLevel::Far;
    return std::make_unique<ForestSimulation>(std::move(forest), options);
}

TEST(ForestBytes, ATreeTakesTreeBytes) {
    if (!allocatorReportsUse())
        GTEST_SKIP() << "the allocator does not report its memory use";
    for (const auto& [level, said] : {std::pair(ModalLevel::Far, 262.0), {ModalLevel::Near, 421.0}}) {
        std::size_t taken[2];
        for (const std::size_t count : {10000u, 100000u}) {
            const std::size_t before = bytesInUse();
            const std::unique_ptr<ForestSimulation> simulation = mixedWood(count, level);
            for (int i = 0; i < 20; ++i)
                simulation->advance(i / 60.0);
            taken[count == 100000u] = bytesInUse() - before;
        }
        const double bytes = static_cast<double>(taken[1] - taken[0]) / 90000.0;
        EXPECT_LT(bytes, said + 5.0) << "docs/frame.md, docs/treewind.md";
        EXPECT_GT(bytes, said - 20.0) << "some crowns have fewer patches";
        EXPECT_NEAR(said, static_cast<double>(simulatedTreeBytes(level)), 5.0);
    }
}

TEST(ForestBytes, SteppingDoesNotAllocate) {
    if (!allocatorReportsUse())
        GTEST_SKIP() << "the allocator does not report its memory use";
    const std::unique_ptr<ForestSimulation> simulation = mixedWood(200);
    const auto run = [&](int from, int to) {
        for (int i = from; i < to; ++i)
            simulation->advance(i / 60.0);
    };
    run(0, 20);
    const std::size_t before = bytesInUse();
    run(20, 200);
    EXPECT_EQ(bytesInUse(), before);
}

TEST(ForestBytes, AddingAndRemovingTreesDoesNotLeak) {
    if (!allocatorReportsUse())
        GTEST_SKIP() << "the allocator does not report its memory use";
    const std::unique_ptr<ForestSimulation> simulation = mixedWood(2000);
    const TreePlacement tree = *simulation->placementOf(TreeId(0));
    const auto churn = [&] {
        std::vector<TreeId> ids;
        ids.reserve(1000);
        for (int i = 0; i < 1000; ++i)
            ids.push_back(simulation->addTree(tree).value());
        for (const TreeId id : ids)
            EXPECT_TRUE(simulation->removeTree(id).empty());
    };
    churn();
    const std::size_t before = bytesInUse();
    for (int i = 0; i < 20; ++i)
        churn();
    EXPECT_LE(bytesInUse(), before + 100000u);
}

#endif

} // namespace
} // namespace osgTreeWind
