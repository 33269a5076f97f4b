// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/Version.h>

#include <gtest/gtest.h>

#include <string>

TEST(Version, MatchesTheHeaders) {
    EXPECT_EQ(osgTreeWind::libraryVersion(), std::to_string(OSGTREEWIND_VERSION_MAJOR) + '.' +
                                                 std::to_string(OSGTREEWIND_VERSION_MINOR) + '.' +
                                                 std::to_string(OSGTREEWIND_VERSION_PATCH));
}

TEST(Version, ComparesNumberByNumber) {
    EXPECT_TRUE(OSGTREEWIND_VERSION_AT_LEAST(OSGTREEWIND_VERSION_MAJOR, OSGTREEWIND_VERSION_MINOR,
                                             OSGTREEWIND_VERSION_PATCH));
    EXPECT_TRUE(OSGTREEWIND_VERSION_AT_LEAST(OSGTREEWIND_VERSION_MAJOR - 1, 99, 99));
    EXPECT_FALSE(OSGTREEWIND_VERSION_AT_LEAST(OSGTREEWIND_VERSION_MAJOR + 1, 0, 0));
    EXPECT_FALSE(OSGTREEWIND_VERSION_AT_LEAST(OSGTREEWIND_VERSION_MAJOR, OSGTREEWIND_VERSION_MINOR + 1, 0));
    EXPECT_FALSE(OSGTREEWIND_VERSION_AT_LEAST(OSGTREEWIND_VERSION_MAJOR, OSGTREEWIND_VERSION_MINOR,
                                              OSGTREEWIND_VERSION_PATCH + 1));
}
