// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Deflate.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(Deflate, RestoresBytes) {
    for (const std::string& plain : {std::string(), std::string("\0\xff", 2), std::string(100'000, 'x')})
        EXPECT_EQ(inflated(deflated(plain), plain.size()), plain);
    EXPECT_LT(deflated(std::string(100'000, 'x')).size(), 1000u);
}

TEST(Deflate, RefusesDamagedBytesAndTooManyOfThem) {
    const std::string bytes = deflated("some text that some text repeats");
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_FALSE(inflated(bytes.substr(0, size), 1000)) << size;
    EXPECT_TRUE(inflated(bytes, 32));
    EXPECT_FALSE(inflated(bytes, 31));
}

} // namespace osgTreeWind
