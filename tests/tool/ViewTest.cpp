// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>

namespace {

TEST(View, WithoutADisplayPointsToRender) {
    const Outcome outcome = runTool({"view", example("forest.treewind"), "--frames", "1"}, ".", "DISPLAY= ");
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(
        outcome.err.find("view: cannot open a window; osgtreewind render draws pictures without a display\n"),
        std::string::npos)
        << outcome.err;
}

TEST(View, ABrokenFileIsBadInput) {
    const TemporaryFolder folder;
    const std::string file = folder.write("broken.treewind", "version = 7\n");
    const Outcome outcome = runTool({"view", file});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.err.find(file + ":1:"), std::string::npos) << outcome.err;
}

} // namespace
