// SPDX-License-Identifier: MIT
// Signals end the tool without unfinished files.
#include <tests/tool/Tool.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

/// Simulates for hours. @param wrapper the command that runs the tool and ends it.
Outcome simulateUnder(const std::string& wrapper, const TemporaryFolder& folder, const std::string& output,
                      const std::string& rest = "") {
    return runShell(wrapper + ' ' + OSGTREEWIND_TOOL + " simulate " + quoted(example("thesis.treewind")) +
                        " --duration 100000 -o " + output + rest,
                    folder.path());
}

} // namespace

TEST(Interrupt, RemovesUnfinishedFiles) {
    for (const auto& [signal, status] :
         std::vector<std::pair<std::string, int>>{{"INT", 130}, {"TERM", 143}, {"HUP", 129}}) {
        const TemporaryFolder folder;
        const Outcome outcome =
            simulateUnder("timeout --preserve-status -k 10 -s " + signal + " 1", folder, "motion.csv");
        EXPECT_EQ(outcome.exitCode, status) << outcome.err;
        EXPECT_EQ(folder.countFiles(), 0u) << signal;
    }
}

TEST(Interrupt, LeavesIgnoredSignalsIgnored) {
    const TemporaryFolder folder;
    const Outcome outcome =
        simulateUnder("trap '' HUP; timeout -k 1 -s HUP 1 nohup", folder, "motion.csv"); // then SIGKILL
    EXPECT_EQ(outcome.exitCode, 137) << outcome.err;
}

TEST(Interrupt, DoesNotWaitForAStoppedReader) {
    const TemporaryFolder folder;
    const Outcome outcome = simulateUnder("( timeout --preserve-status -k 4 -s INT 1", folder, "-",
                                          "; echo $? >status ) | { sleep 6; cat >/dev/null; }");
    EXPECT_EQ(contentOf(folder.path() + "/status"), "130\n") << outcome.err;
}

} // namespace osgTreeWind
