// SPDX-License-Identifier: MIT
// Forests that share the thread pool of the process, or a host's threads.
#include <tests/ProcessThreadCount.h>
#include <tests/motion/OneTree.h>
#include <tests/motion/Sapling.h>

#include <osgTreeWind/base/ThreadPool.h>
#include <osgTreeWind/motion/ForestSimulation.h>
#include <osgTreeWind/motion/MovingForest.h>
#include <osgTreeWind/wind/FunctionWind.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace osgTreeWind {
namespace {

ForestDescription saplingWood(std::size_t trees) {
    ForestDescription forest;
    forest.species = {sapling()};
    forest.wind = std::make_shared<UniformWind>(glm::vec3(6.0f, 2.0f, 0.0f));
    for (std::size_t i = 0; i < trees; ++i) {
        TreePlacement tree;
        tree.position = {5.0 * static_cast<double>(i % 40), 5.0 * static_cast<double>(i / 40), 0.0};
        tree.heading = 0.1f * static_cast<float>(i);
        forest.trees.push_back(tree);
    }
    return forest;
}

std::vector<glm::vec2> leansOf(const ForestSimulation& simulation) {
    std::vector<glm::vec2> leans;
    for (std::size_t slot = 0; slot < movingForest(simulation).trees().size(); ++slot)
        leans.push_back(movingForest(simulation).modal()->lean(slot));
    return leans;
}

/// Runs jobs alternately in the calling thread and in a second one.
void runInTwo(std::size_t count, const std::function<void(std::size_t)>& job) {
    std::thread other([&] {
        for (std::size_t i = 1; i < count; i += 2)
            job(i);
    });
    for (std::size_t i = 0; i < count; i += 2)
        job(i);
    other.join();
}

} // namespace

TEST(ForestThreads, TwoThreadsAdvanceCopiesOfOneForest) {
    SimulationOptions lent;
    lent.executor = ThreadPool::executor(3);
    for (const SimulationOptions& options : {SimulationOptions(), lent}) {
        const ForestSimulation simulation(saplingWood(300), options);
        std::vector<std::shared_ptr<ForestSimulation>> copies;
        for (int i = 0; i < 4; ++i)
            copies.push_back(simulation.cloneAtRest());
        std::vector<std::thread> threads;
        for (const auto& copy : copies)
            threads.emplace_back([&] { run(*copy, 100); });
        for (std::thread& thread : threads)
            thread.join();
        SimulationOptions alone;
        alone.executor = runInTurn;
        ForestSimulation expected(saplingWood(300), alone);
        run(expected, 100);
        for (const auto& copy : copies)
            EXPECT_EQ(leansOf(*copy), leansOf(expected));
    }
}

TEST(ForestThreads, HundredsOfForestsShareTheThreadPool) {
    const ForestSimulation first(saplingWood(300)); // starts the thread pool
    const std::ptrdiff_t threads = processThreadCount();
    std::vector<std::unique_ptr<ForestSimulation>> forests;
    for (int i = 0; i < 200; ++i) {
        forests.push_back(std::make_unique<ForestSimulation>(saplingWood(260)));
        run(*forests.back(), 2);
    }
    EXPECT_EQ(processThreadCount(), threads);
    std::atomic<std::size_t> next{0};
    std::vector<std::thread> viewers;
    for (int i = 0; i < 3; ++i)
        viewers.emplace_back([&] {
            for (std::size_t k = next++; k < forests.size(); k = next++)
                run(*forests[k], 5);
        });
    for (std::thread& viewer : viewers)
        viewer.join();
    for (const auto& forest : forests)
        ASSERT_EQ(leansOf(*forest), leansOf(*forests.front()));
    EXPECT_EQ(processThreadCount(), threads);
}

TEST(ForestThreads, AHostCanSetItsExecutorAtAnyTime) {
    ForestSimulation simulation(saplingWood(300)), expected(saplingWood(300));
    std::atomic<int> calls{0};
    simulation.setExecutor([&](std::size_t count, const std::function<void(std::size_t)>& job) {
        ++calls;
        runInTwo(count, job);
    });
    run(simulation, 20);
    EXPECT_GE(calls, 20);
    const std::shared_ptr<ForestSimulation> copy = simulation.cloneAtRest();
    const int before = calls;
    run(*copy, 20);
    EXPECT_GE(calls, before + 20) << "and to copies";
    simulation.setExecutor(nullptr);
    const int lent = calls;
    simulation.advance(1.0);
    EXPECT_EQ(calls, lent);
    run(expected, 20);
    EXPECT_EQ(leansOf(*copy), leansOf(expected));
}

TEST(ForestThreads, AWindCanUseTheSameThreads) {
    const auto steady = [](const glm::vec3& position, double) {
        return glm::vec3(4.0f + 0.01f * position.x, 1.0f, 0.0f);
    };
    ForestDescription plain = saplingWood(300), busy = plain;
    plain.wind = std::make_shared<FunctionWind>(steady);
    busy.wind = std::make_shared<FunctionWind>([&](const glm::vec3& position, double time) {
        std::atomic<int> done{0};
        ThreadPool::executor()(4, [&](std::size_t) { ++done; });
        return done == 4 ? steady(position, time) : glm::vec3(0.0f);
    });
    ForestSimulation expected(plain), simulation(busy);
    run(expected, 5);
    run(simulation, 5);
    EXPECT_EQ(leansOf(simulation), leansOf(expected));
}

TEST(ForestThreads, AWaitingJobCanRunAnother) {
    // Some host thread pools run other jobs while they wait.
    ForestSimulation inner(saplingWood(8));
    inner.advance(0.0);
    double time = 0.0;
    const auto nested = [&](const glm::vec3& position, double) {
        inner.advance(time += 0.01);
        return glm::vec3(4.0f + 0.01f * position.x, 1.0f, 0.0f);
    };
    ForestDescription plain = saplingWood(40), busy = plain;
    plain.wind = std::make_shared<FunctionWind>(
        [](const glm::vec3& position, double) { return glm::vec3(4.0f + 0.01f * position.x, 1.0f, 0.0f); });
    busy.wind = std::make_shared<FunctionWind>(nested);
    ForestSimulation expected(plain), simulation(busy);
    run(expected, 5);
    run(simulation, 5);
    EXPECT_EQ(leansOf(simulation), leansOf(expected));
}

} // namespace osgTreeWind
