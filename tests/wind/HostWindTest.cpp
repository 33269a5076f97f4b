// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/HostWind.h>

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

TEST(HostWind, IsCalmUntilSet) {
    HostWind wind;
    wind.setForestToScene(quarterTurn);
    EXPECT_EQ(wind.get()->field, nullptr);
    EXPECT_EQ(wind.fieldWithoutTrees(), nullptr);
}

TEST(HostWind, IsTransformedToTheForest) {
    const auto east = std::make_shared<UniformWind>(glm::vec3(3, 0, 0));
    HostWind wind(east);
    EXPECT_EQ(wind.fieldWithoutTrees(), east) << "the same field";
    wind.setForestToScene(quarterTurn);
    const WindFieldPtr here = wind.fieldWithoutTrees();
    EXPECT_LT(glm::distance(here->velocity({0, 0, 0}, 0.0), glm::vec3(0, -3, 0)), 1e-6f);
    EXPECT_EQ(wind.fieldWithoutTrees(), here) << "cached";
    EXPECT_EQ(wind.get()->field, east) << "unchanged";

    wind.set(std::make_shared<UniformWind>(glm::vec3(0, 3, 0)));
    EXPECT_LT(glm::distance(wind.fieldWithoutTrees()->velocity({0, 0, 0}, 0.0), glm::vec3(3, 0, 0)), 1e-6f);
    wind.setForestToScene(glm::dmat4(1.0));
    EXPECT_EQ(wind.fieldWithoutTrees(), wind.get()->field);
}

TEST(HostWind, KeepsThePreviousCanopyIfUnset) {
    Wind first;
    first.canopy.emplace().source = CanopySource::Forest;
    HostWind wind(first);
    wind.set(std::make_shared<UniformWind>(glm::vec3(3, 0, 0)));
    EXPECT_EQ(wind.get()->canopy->source, CanopySource::Forest);
    Wind open = *wind.get();
    open.canopy.emplace();
    wind.set(open);
    EXPECT_EQ(wind.get()->canopy->source, CanopySource::None);
}

TEST(HostWind, AnyThreadMaySetIt) {
    HostWind wind;
    std::atomic<bool> running{true};
    std::thread simulator([&] {
        for (int i = 0; running; ++i)
            wind.set(std::make_shared<UniformWind>(glm::vec3(static_cast<float>(i), 0, 0)));
    });
    float last = 0.0f;
    for (int i = 0; i < 1000; ++i) {
        const WindFieldPtr here = wind.fieldWithoutTrees();
        const float now = here ? here->velocity({0, 0, 0}, 0.0).x : 0.0f;
        ASSERT_GE(now, last);
        last = now;
    }
    running = false;
    simulator.join();
}

} // namespace osgTreeWind
