// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/GivenWind.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <atomic>
#include <thread>

namespace osgTreeWind {
namespace {

const glm::dmat4 quarterTurn = glm::rotate(glm::dmat4(1.0), glm::half_pi<double>(), glm::dvec3(0, 0, 1));

} // namespace

TEST(GivenWind, IsCalmUntilItIsGiven) {
    GivenWind wind;
    wind.setPlace(quarterTurn);
    EXPECT_EQ(wind.get()->field, nullptr);
    EXPECT_EQ(wind.here(), nullptr);
}

TEST(GivenWind, IsMetWhereTheForestStands) {
    const auto east = std::make_shared<UniformWind>(glm::vec3(3, 0, 0));
    GivenWind wind(east);
    EXPECT_EQ(wind.here(), east) << "as it is";
    wind.setPlace(quarterTurn);
    const WindFieldPtr here = wind.here();
    EXPECT_LT(glm::distance(here->velocity({0, 0, 0}, 0.0), glm::vec3(0, -3, 0)), 1e-6f);
    EXPECT_EQ(wind.here(), here) << "made once";
    EXPECT_EQ(wind.get()->field, east) << "as it was given";

    wind.set(std::make_shared<UniformWind>(glm::vec3(0, 3, 0)));
    EXPECT_LT(glm::distance(wind.here()->velocity({0, 0, 0}, 0.0), glm::vec3(3, 0, 0)), 1e-6f);
    wind.setPlace(glm::dmat4(1.0));
    EXPECT_EQ(wind.here(), wind.get()->field);
}

TEST(GivenWind, AWindWithoutACanopyKeepsThatOfTheOneBefore) {
    Wind first;
    first.canopy.emplace().source = CanopySource::Forest;
    GivenWind wind(first);
    wind.set(std::make_shared<UniformWind>(glm::vec3(3, 0, 0)));
    EXPECT_EQ(wind.get()->canopy->source, CanopySource::Forest);
    Wind open = *wind.get();
    open.canopy.emplace();
    wind.set(open);
    EXPECT_EQ(wind.get()->canopy->source, CanopySource::None);
}

TEST(GivenWind, AnyThreadMayReplaceIt) {
    GivenWind wind;
    std::atomic<bool> running{true};
    std::thread simulator([&] {
        for (int i = 0; running; ++i)
            wind.set(std::make_shared<UniformWind>(glm::vec3(static_cast<float>(i), 0, 0)));
    });
    float last = 0.0f;
    for (int i = 0; i < 1000; ++i) {
        const WindFieldPtr here = wind.here();
        const float now = here ? here->velocity({0, 0, 0}, 0.0).x : 0.0f;
        ASSERT_GE(now, last);
        last = now;
    }
    running = false;
    simulator.join();
}

} // namespace osgTreeWind
