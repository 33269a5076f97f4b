// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/StreamedWind.h>

#include <tests/base/FirstProblem.h>

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <thread>

namespace osgTreeWind {

namespace {

GridWind::Grid gridOf(float u) {
    GridWind::Grid grid;
    grid.points = {8, 8, 2};
    grid.values.assign(3 * 8 * 8 * 2, u);
    return grid;
}

std::shared_ptr<StreamedWind> made(float u) {
    auto wind = StreamedWind::create(gridOf(u));
    EXPECT_TRUE(wind) << firstProblem(wind);
    return wind.value();
}

} // namespace

TEST(StreamedWind, UpdateReplacesTheWind) {
    const auto wind = made(1.0f);
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(1.0f));
    EXPECT_TRUE(wind->update({gridOf(2.0f).values}).empty());
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(2.0f));
}

TEST(StreamedWind, RefusedUpdatesChangeNothing) {
    const auto wind = made(1.0f);
    const Diagnostics few = wind->update({std::vector<float>{1, 2, 3}});
    ASSERT_FALSE(few.empty());
    EXPECT_EQ(few.front().text(), "values: expected 384 numbers (3 x 8 x 8 x 2 points), found 3");
    std::vector<float> values = gridOf(2.0f).values;
    values.back() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(wind->update({values}).empty());
    EXPECT_EQ(toString(wind->update({Span<float>(nullptr, 384)})),
              "velocities: expected numbers, found a null pointer");
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(1.0f));
}

TEST(StreamedWind, RefusesSeveralTimes) {
    GridWind::Grid grid = gridOf(1.0f);
    grid.times = {0, 1};
    EXPECT_EQ(firstProblem(StreamedWind::create(grid)), "times: expected one time at most, found 2");
}

/// u = x, so that a velocity tells where the grid was sampled.
TEST(StreamedWind, UpdatesMoveTheGrid) {
    GridWind::Grid grid;
    grid.points = {2, 1, 2};
    grid.heights = {5.0f, 9.0f};
    grid.values = {0, 0, 0, 1, 0, 0, 0, 0, 4, 1, 0, 4};
    const auto wind = StreamedWind::create(grid).value();
    EXPECT_EQ(wind->velocity({0.5f, 0, 5}, 0), glm::vec3(0.5f, 0, 0));
    EXPECT_TRUE(wind->update({grid.values, glm::dvec3(10, 0, 100), {}}).empty());
    EXPECT_EQ(wind->velocity({10.5f, 0, 105}, 0), glm::vec3(0.5f, 0, 0));
    EXPECT_EQ(wind->velocity({10.25f, 0, 107}, 0), glm::vec3(0.25f, 0, 2));
    EXPECT_TRUE(wind->update({grid.values}).empty());
    EXPECT_EQ(wind->velocity({10.5f, 0, 105}, 0), glm::vec3(0.5f, 0, 0))
        << "the grid stays at its last position";
    const glm::dvec3 nowhere(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(wind->update({grid.values, nowhere, {}}).front().text(), "origin: expected finite metres");
}

TEST(StreamedWind, IsLinearBetweenTheLastTwoTimes) {
    GridWind::Grid grid = gridOf(1.0f);
    grid.times = {10.0};
    const auto wind = StreamedWind::create(grid).value();
    EXPECT_EQ(wind->velocity({}, 99), glm::vec3(1.0f)) << "a single update holds at all times";
    EXPECT_TRUE(wind->update({gridOf(3.0f).values, {}, 12.0}).empty());
    EXPECT_TRUE(wind->update({gridOf(7.0f).values, {}, 13.0}).empty());
    const std::vector<WindPlace> places(100);
    std::vector<glm::vec3> winds(100);
    for (const auto& [time, u] :
         {std::pair{0.0, 3.0f}, {12.0, 3.0f}, {12.25, 4.0f}, {13.0, 7.0f}, {50.0, 7.0f}}) {
        wind->sample(places.data(), places.size(), time, winds.data());
        EXPECT_EQ(winds, std::vector<glm::vec3>(100, glm::vec3(u))) << time;
        EXPECT_EQ(wind->velocity({}, time), glm::vec3(u)) << time;
    }
    EXPECT_TRUE(wind->update({gridOf(5.0f).values}).empty());
    EXPECT_EQ(wind->velocity({}, 12.25), glm::vec3(5.0f)) << "an update without a time applies immediately";
}

/// Between two positions of the grid the wind at each place is interpolated between both updates.
TEST(StreamedWind, MovingGridIsLinearInTimeAtEachPlace) {
    GridWind::Grid grid;
    grid.points = {2, 1, 1};
    grid.values = {0, 0, 0, 8, 0, 0};
    grid.times = {0.0};
    const auto wind = StreamedWind::create(grid).value();
    EXPECT_TRUE(wind->update({grid.values, glm::dvec3(0.5, 0, 0), 1.0}).empty());
    EXPECT_EQ(wind->velocity({0.5f, 0, 0}, 0.5).x, 2.0f) << "mean of 4 and 0";
}

TEST(StreamedWind, TimesMustIncrease) {
    const auto wind = made(1.0f);
    const std::vector<float> values = gridOf(2.0f).values;
    EXPECT_TRUE(wind->update({values, {}, 5.0}).empty());
    for (const double time : {5.0, 4.0, 1e16, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_EQ(wind->update({values, {}, time}).front().key, "time") << time;
    EXPECT_EQ(wind->update({values, {}, 4.0}).front().text(),
              "time: expected seconds after 5 and within 1e15, found 4");
}

/// Two threads update while two sample.
TEST(StreamedWind, ThreadsUpdateAndSampleConcurrently) {
    const auto wind = made(0.0f);
    std::atomic<int> writing{2};
    std::vector<std::thread> threads;
    for (int writer = 0; writer < 2; ++writer)
        threads.emplace_back([&] {
            for (int i = 1; i <= 300; ++i)
                EXPECT_TRUE(
                    wind->update({gridOf(static_cast<float>(i)).values, glm::dvec3(i, 0, 0), {}}).empty());
            --writing;
        });
    for (int reader = 0; reader < 2; ++reader)
        threads.emplace_back([&] {
            const std::vector<WindPlace> places(70);
            std::vector<glm::vec3> winds(70);
            do {
                wind->sample(places.data(), places.size(), 0.0, winds.data());
                EXPECT_EQ(winds, std::vector<glm::vec3>(70, winds.front()));
            } while (writing > 0);
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(300.0f));
}

TEST(StreamedWind, UpdatesAreAtomic) {
    const auto wind = made(0.0f);
    std::atomic<bool> done{false};
    std::thread writer([&] {
        for (int i = 1; i <= 2000; ++i)
            EXPECT_TRUE(wind->update({gridOf(static_cast<float>(i)).values}).empty());
        done = true;
    });
    std::vector<WindPlace> places;
    std::vector<glm::vec3> winds(64);
    for (int i = 0; i < 64; ++i)
        places.emplace_back(i % 8, i / 8, 0.5f);
    float latest = 0.0f;
    bool whole = true, ordered = true;
    while (!done) {
        wind->sample(places.data(), places.size(), 0.0, winds.data());
        for (const glm::vec3& velocity : winds)
            whole = whole && velocity == glm::vec3(winds.front().x);
        ordered = ordered && winds.front().x >= latest;
        latest = winds.front().x;
    }
    writer.join();
    EXPECT_TRUE(whole) << "a sample saw parts of two updates";
    EXPECT_TRUE(ordered) << "a sample saw an older update";
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(2000.0f));
}

} // namespace osgTreeWind
