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

TEST(StreamedWind, UpdateIsTheWindFromThenOn) {
    const auto wind = made(1.0f);
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(1.0f));
    EXPECT_TRUE(wind->update(gridOf(2.0f).values).empty());
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(2.0f));
}

TEST(StreamedWind, BadUpdatesAreRefusedAndChangeNothing) {
    const auto wind = made(1.0f);
    const Diagnostics few = wind->update({1, 2, 3});
    ASSERT_FALSE(few.empty());
    EXPECT_EQ(few.front().text(), "values: expected 384 numbers (3 x 8 x 8 x 2 points), found 3");
    std::vector<float> values = gridOf(2.0f).values;
    values.back() = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(wind->update(values).empty());
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(1.0f));
}

TEST(StreamedWind, SeveralTimesAreRefused) {
    GridWind::Grid grid = gridOf(1.0f);
    grid.times = {0, 1};
    EXPECT_EQ(firstProblem(StreamedWind::create(grid)), "times: expected one time at most, found 2");
}

TEST(StreamedWind, EverySampleSeesOneUpdateWhole) {
    const auto wind = made(0.0f);
    std::atomic<bool> done{false};
    std::thread writer([&] {
        for (int i = 1; i <= 2000; ++i)
            EXPECT_TRUE(wind->update(gridOf(static_cast<float>(i)).values).empty());
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
    EXPECT_TRUE(ordered) << "an older wind came back";
    EXPECT_EQ(wind->velocity({}, 0), glm::vec3(2000.0f));
}

} // namespace osgTreeWind
