// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>

#include <osgTreeWind/base/Wire.h>

#include <gtest/gtest.h>

#include <sys/mman.h>
#include <unistd.h>

namespace osgTreeWind {

namespace {

using Lists = std::vector<std::vector<double>>;

/// Sends and receives; overwrites the byte at offset `at` in between, unless `at` is negative.
std::optional<Result<Lists>> sent(Result<Lists> lists, off_t at = -1, char byte = 0) {
    const int file = memfd_create("wire", 0);
    EXPECT_TRUE(Wire::send(file, lists));
    if (at >= 0) {
        EXPECT_EQ(pwrite(file, &byte, 1, at), 1);
    }
    lseek(file, 0, SEEK_SET);
    auto received = Wire::receive<Lists>(file);
    close(file);
    return received;
}

} // namespace

TEST(Wire, TransfersNestedListsAndProblems) {
    const Lists lists = {{1.0, 2.5}, {}, {-3.0}};
    const auto received = sent(lists);
    ASSERT_TRUE(received && *received);
    EXPECT_EQ(received->value(), lists);
    const auto problem = sent(Diagnostic{"a", 3, 7, "b", "c"});
    ASSERT_TRUE(problem);
    EXPECT_EQ(firstProblem(*problem), "a:3:7: b: c");
}

TEST(Wire, RejectsDamagedData) {
    EXPECT_TRUE(sent(Lists{{1.0}}, 0, 1));
    EXPECT_FALSE(sent(Lists{{1.0}}, 0, 10));
    EXPECT_FALSE(sent(Lists{{1.0}}, 1, 100)) << "more lists announced than sent";
}

} // namespace osgTreeWind
