// SPDX-License-Identifier: MIT
#include <tests/EnvironmentVariable.h>

#include <osgTreeWind/base/UserCache.h>
#include <osgTreeWind/system/Program.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

TEST(UserCache, FolderFollowsTheEnvironment) {
    const std::string drive = listSeparator == ';' ? "C:" : ""; // of Windows
    {
        const EnvironmentVariable cache("OSGTREEWIND_FORM_CACHE", "off");
        EXPECT_EQ(userCacheFolder(), "");
    }
    const EnvironmentVariable none("OSGTREEWIND_FORM_CACHE", "");
    const EnvironmentVariable home("HOME", (drive + "/home/user").c_str());
    {
        const EnvironmentVariable caches("XDG_CACHE_HOME", (drive + "/var/caches").c_str());
        EXPECT_EQ(userCacheFolder(), drive + "/var/caches/osgtreewind");
    }
    const EnvironmentVariable relative("XDG_CACHE_HOME", "here");
    EXPECT_EQ(userCacheFolder(), drive + "/home/user/.cache/osgtreewind") << "a relative folder is ignored";
    const EnvironmentVariable noHome("HOME", "");
    const EnvironmentVariable local("LOCALAPPDATA", "");
    EXPECT_EQ(userCacheFolder(), "");
}

} // namespace osgTreeWind
