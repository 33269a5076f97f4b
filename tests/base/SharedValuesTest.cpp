// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/SharedValues.h>

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace osgTreeWind {
namespace {

using Texts = SharedConstants<int, std::string>;

auto text(const char* value) {
    return [value] { return std::make_shared<const std::string>(value); };
}

TEST(SharedValues, MakesAValueOncePerKeyWhileItIsHeld) {
    Texts texts;
    const auto one = texts.get(1, text("one"));
    EXPECT_EQ(texts.get(1, text("another")), one);
    EXPECT_EQ(texts.find(1), one);
    EXPECT_EQ(*texts.get(2, text("two")), "two");
    EXPECT_EQ(texts.find(2), nullptr) << "it was not held";
    EXPECT_EQ(*texts.get(2, text("second")), "second");
    EXPECT_EQ(texts.find(3), nullptr);
}

TEST(SharedValues, RetriesAfterAFailure) {
    Texts texts;
    EXPECT_THROW(texts.get(1, []() -> std::shared_ptr<const std::string> { throw std::bad_alloc(); }),
                 std::bad_alloc);
    EXPECT_EQ(texts.get(1, [] { return nullptr; }), nullptr);
    EXPECT_EQ(*texts.get(1, text("one")), "one");
}

TEST(SharedValues, ConcurrentRequestsGetTheSameValue) {
    constexpr int keys = 5;
    Texts texts;
    std::atomic<int> made{0};
    std::vector<std::vector<std::shared_ptr<const std::string>>> got(8);
    std::vector<std::thread> threads;
    for (auto& own : got)
        threads.emplace_back([&] {
            for (int i = 0; i < 200; ++i)
                own.push_back(texts.get(i % keys, [&] {
                    ++made;
                    return std::make_shared<const std::string>(std::to_string(i % keys));
                }));
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(made, keys);
    for (const auto& own : got)
        for (std::size_t i = 0; i < own.size(); ++i) {
            ASSERT_EQ(own[i], got[0][i % keys]);
            ASSERT_EQ(*own[i], std::to_string(i % keys));
        }
}

TEST(SharedValues, ThreadsMayReleaseValuesWhileOthersRequestThem) {
    Texts texts;
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int i = 0; i < 500; ++i)
                ASSERT_EQ(
                    *texts.get(
                        (i + t) % 7,
                        [&] { return std::make_shared<const std::string>(std::to_string((i + t) % 7)); }),
                    std::to_string((i + t) % 7));
        });
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace
} // namespace osgTreeWind
