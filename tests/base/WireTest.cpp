// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/base/WireFile.h>

#include <osgTreeWind/base/Wire.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

using Lists = std::vector<std::vector<double>>;

/// Sends and receives; overwrites the byte at offset `at` in between, unless `at` is negative.
std::optional<Result<Lists>> sent(Result<Lists> lists, std::int64_t at = -1, char byte = 0) {
    WireFile file;
    EXPECT_TRUE(Wire::send(file.descriptor(), lists));
    if (at >= 0)
        file.overwrite(at, byte);
    file.rewind();
    return Wire::receive<Lists>(file.descriptor());
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
