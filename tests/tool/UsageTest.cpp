// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

namespace {

const std::string thesis = example("thesis.treewind");

struct Refused {
    const char* name;
    std::vector<std::string> words;
    const char* message; ///< Part of standard error.
};

class UsageRefuses : public testing::TestWithParam<Refused> {};

} // namespace

TEST_P(UsageRefuses, WithExitCode2AndNothingElse) {
    const TemporaryFolder folder;
    const Outcome outcome = runTool(GetParam().words, folder.path());
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find(GetParam().message), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

INSTANTIATE_TEST_SUITE_P(
    , UsageRefuses,
    testing::Values(Refused{"nothing", {}, "subcommand is required"},
                    Refused{"unknownCommand", {"bogus"}, "subcommand is required"},
                    Refused{"unknownOption", {"info", thesis, "--jsno"}, "--jsno"},
                    Refused{"twoFiles", {"info", thesis, thesis}, "not expected"},
                    Refused{"infoWithoutFile", {"info"}, "file is required"},
                    Refused{"validateWithoutFile", {"validate"}, "file is required"},
                    Refused{"renderWithoutFile", {"render"}, "file is required"},
                    Refused{"simulateWithoutFile", {"simulate"}, "file is required"},
                    Refused{"missingFile", {"info", "absent.treewind"}, "absent.treewind: no such file"},
                    Refused{"folder", {"info", "/tmp"}, "/tmp: not a regular file"},
                    Refused{"renderMissing", {"render", "absent.treewind"}, "no such file"},
                    Refused{"simulateMissing", {"simulate", "absent.treewind"}, "no such file"},
                    Refused{"sizeZero", {"render", thesis, "--size", "0x10"}, "--size"},
                    Refused{"sizeHuge", {"render", thesis, "--size", "99999x1"}, "--size"},
                    Refused{"sizeText", {"render", thesis, "--size", "axb"}, "--size"},
                    Refused{"sizeNegative", {"render", thesis, "--size", "-8x8"}, "--size"},
                    Refused{"sizeTooLargeForSamples",
                            {"render", thesis, "--size", "9000x9", "--samples", "4"},
                            "from 1 to 8192"},
                    Refused{"framesWithoutPattern",
                            {"render", thesis, "-o", "a.png", "--frames", "3"},
                            "--output: 3 frames need a name with %04d"},
                    Refused{"noFrames", {"render", thesis, "--frames", "0"}, "--frames"},
                    Refused{"unknownFormat", {"render", thesis, "-o", "a.xyz"}, "ends in .png or .mp4"},
                    Refused{"unknownBackend", {"render", thesis, "--backend", "glx"}, "--backend"},
                    Refused{"unknownPose", {"render", thesis, "--pose", "t"}, "--pose"},
                    Refused{"fpsNaN", {"render", thesis, "--fps", "nan"}, "--fps"},
                    Refused{"startInfinite", {"render", thesis, "--start", "inf"}, "--start"},
                    Refused{"eyeOfTwoNumbers", {"render", thesis, "--eye", "1,2"}, "--eye"},
                    Refused{"eyeNaN", {"render", thesis, "--eye", "1,2,nan"}, "--eye"},
                    Refused{
                        "eyeAtCenter", {"render", thesis, "--eye", "1,2,3", "--center", "1,2,3"}, "--eye"},
                    Refused{"durationNaN", {"simulate", thesis, "--duration", "nan"}, "--duration"},
                    Refused{"durationNegative", {"simulate", thesis, "--duration", "-1"}, "--duration"},
                    Refused{"simulateFpsZero", {"simulate", thesis, "--fps", "0"}, "--fps"}),
    [](const testing::TestParamInfo<Refused>& info) { return std::string(info.param.name); });

TEST(Usage, HelpOfEveryCommandShowsAnExampleOrItsFile) {
    for (const std::string command : {"info", "validate", "render", "simulate"}) {
        const Outcome outcome = runTool({command, "--help"});
        EXPECT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(outcome.err, "");
        EXPECT_NE(outcome.out.find("osgtreewind " + command), std::string::npos) << outcome.out;
    }
}

TEST(Usage, HelpNamesAllCommandsAndExitCodes) {
    const Outcome outcome = runTool({"--help"});
    EXPECT_EQ(outcome.exitCode, 0);
    for (const char* text : {"info", "validate", "render", "simulate", "Examples:", "Exit status: 0"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
}

TEST(Usage, VersionIsTheProjects) {
    const Outcome outcome = runTool({"--version"});
    EXPECT_EQ(outcome.exitCode, 0);
    EXPECT_EQ(outcome.out, "osgtreewind " OSGTREEWIND_VERSION "\n");
}

TEST(Usage, AnUnwritableOutputIsExitCode1) {
    const TemporaryFolder folder;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"render", thesis, "--size", "32x32", "-o", "absent/a.png"},
          {"simulate", thesis, "--duration", "0", "-o", "absent/a.csv"},
          {"simulate", thesis, "--duration", "0", "-o", "/dev/full"}}) {
        const Outcome outcome = runTool(words, folder.path());
        EXPECT_EQ(outcome.exitCode, 1) << words[0];
        EXPECT_NE(outcome.err.find(words.back() + ": "), std::string::npos) << outcome.err;
    }
}

TEST(Usage, AFullStandardOutputIsExitCode1) {
    for (const std::string command : {"info ", "simulate --duration 0 "})
        EXPECT_EQ(runShell(OSGTREEWIND_TOOL " " + command + quoted(thesis) + " >/dev/full").exitCode, 1)
            << command;
}

TEST(Usage, AForestThatDoesNotFitIntoMemoryIsExitCode2) {
    const std::string forest = example("forest.treewind");
    const TemporaryFolder folder;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"simulate", forest, "--duration", "0"},
          {"validate", forest},
          {"info", forest},
          {"render", forest, "-o", "a.png", "--size", "32x32"}}) {
        const Outcome outcome = runTool(words, folder.path(), "OSGTREEWIND_MAX_MEMORY=1M ");
        EXPECT_EQ(outcome.exitCode, 2) << words[0];
        EXPECT_NE(outcome.err.find("40 trees of these species need about "), std::string::npos)
            << outcome.err;
    }
}
