// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>

#include <osgTreeWind/base/UserCache.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(UserCache, FolderFollowsTheEnvironment) {
    {
        const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", "off");
        EXPECT_EQ(userCacheFolder(), "");
    }
    const EnvironmentVariable none("OSGTREEWIND_FORM_CACHE", "");
    if (listSeparator == ';') { // Windows
        const EnvironmentVariable caches("LOCALAPPDATA", "C:\\Caches");
        EXPECT_EQ(userCacheFolder(), "C:/Caches/osgtreewind");
        const EnvironmentVariable relative("LOCALAPPDATA", "here");
        EXPECT_EQ(userCacheFolder(), "") << "a relative folder is ignored";
    }
    const EnvironmentVariable home("HOME", "/home/user"), local("LOCALAPPDATA", "");
    if (listSeparator == ':') {
        {
            const EnvironmentVariable caches("XDG_CACHE_HOME", "/var/caches");
            EXPECT_EQ(userCacheFolder(), "/var/caches/osgtreewind");
        }
        const EnvironmentVariable relative("XDG_CACHE_HOME", "here");
        EXPECT_EQ(userCacheFolder(), "/home/user/.cache/osgtreewind") << "a relative folder is ignored";
    }
    const EnvironmentVariable noCaches("XDG_CACHE_HOME", ""), relativeHome("HOME", "here");
    EXPECT_EQ(userCacheFolder(), "");
    const EnvironmentVariable noHome("HOME", "");
    EXPECT_EQ(userCacheFolder(), "");
}

} // namespace osgTreeWind
