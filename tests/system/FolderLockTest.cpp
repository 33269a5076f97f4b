// SPDX-License-Identifier: MIT
#include <tests/io/TemporaryFolder.h>

#include <osgTreeWind/system/FolderLock.h>

#include <gtest/gtest.h>

#include <optional>

namespace osgTreeWind {

TEST(FolderLock, ExcludesOthersUntilItIsDestroyed) {
    const TemporaryFolder folder;
    std::optional<FolderLock> lock(folder.path());
    EXPECT_TRUE(lock->isHeld());
    EXPECT_EQ(lock->problem(), "");
    EXPECT_FALSE(FolderLock(folder.path()).isHeld());
    EXPECT_EQ(FolderLock(folder.path()).problem(), "");
    lock.reset();
    EXPECT_EQ(folder.countFiles(), 0u);
    EXPECT_TRUE(FolderLock(folder.path()).isHeld());
}

TEST(FolderLock, TellsAMissingFolder) {
    const TemporaryFolder folder;
    const FolderLock lock(folder.path() + "/missing");
    EXPECT_FALSE(lock.isHeld());
    EXPECT_NE(lock.problem(), "");
}

} // namespace osgTreeWind
