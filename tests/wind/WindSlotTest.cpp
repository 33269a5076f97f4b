// SPDX-License-Identifier: MIT
#include <osgTreeWind/wind/WindSlot.h>

#include <osgTreeWind/wind/UniformWind.h>

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace osgTreeWind {

TEST(WindSlot, IsCalmUntilSet) {
    EXPECT_TRUE(WindSlot().get()->isCalm());
}

TEST(WindSlot, KeepsTheWindIfTheNextIsInvalid) {
    const auto east = std::make_shared<UniformWind>(glm::vec3(3, 0, 0));
    WindSlot wind(east);
    Wind invalid;
    invalid.frame = static_cast<WindFrame>(9);
    EXPECT_FALSE(wind.set(invalid).empty());
    EXPECT_EQ(wind.get()->field, east);
}

TEST(WindSlot, AnyThreadMaySetIt) {
    WindSlot wind;
    std::atomic<bool> running{true};
    std::thread simulator([&] {
        for (int i = 0; running; ++i)
            EXPECT_TRUE(
                wind.set(std::make_shared<UniformWind>(glm::vec3(static_cast<float>(i), 0, 0))).empty());
    });
    float last = 0.0f;
    for (int i = 0; i < 1000; ++i) {
        const std::shared_ptr<const Wind> here = wind.get();
        const float now = here->field ? here->field->velocity({0, 0, 0}, 0.0).x : 0.0f;
        ASSERT_GE(now, last);
        last = now;
    }
    running = false;
    simulator.join();
}

} // namespace osgTreeWind
