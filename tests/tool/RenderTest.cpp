// SPDX-License-Identifier: MIT
#include <tests/TestData.h>
#include <tests/tool/Pictures.h>
#include <tests/tool/Tool.h>

#include <cmath>

namespace {

/// Renders examples/thesis.treewind as a small picture.
Outcome render(const TemporaryFolder& folder, const std::string& output,
               std::vector<std::string> options = {}) {
    options.insert(options.begin(), {"render", example("thesis.treewind"), "-o", output, "--size", "160x90"});
    return runTool(options, folder.path());
}

} // namespace

TEST(Render, TheSameArgumentsGiveTheSameBytes) {
    const TemporaryFolder folder;
    EXPECT_EQ(render(folder, "a.png", {"--start", "0.5"}).exitCode, 0);
    EXPECT_EQ(render(folder, "b.png", {"--start", "0.5"}).exitCode, 0);
    const std::string bytes = contentOf(folder.path() + "/a.png");
    EXPECT_GT(bytes.size(), 1000u);
    EXPECT_EQ(bytes, contentOf(folder.path() + "/b.png"));
}

TEST(Render, TheDefaultOutputIsForestPng) {
    const TemporaryFolder folder;
    const Outcome outcome = runTool({"render", example("thesis.treewind")}, folder.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const osg::ref_ptr<osg::Image> image = pictureIn(folder, "forest.png");
    EXPECT_EQ(image->s(), 1280);
    EXPECT_EQ(image->t(), 720);
}

TEST(Render, ShowsSkyOverGreenOverGround) {
    const TemporaryFolder folder;
    EXPECT_EQ(render(folder, "a.png").exitCode, 0);
    const osg::ref_ptr<osg::Image> image = pictureIn(folder, "a.png");
    ASSERT_EQ(image->s(), 160);
    const osg::Vec4 sky = image->getColor(2u, 88u);
    EXPECT_GT(sky.b(), sky.r());
    int green = 0;
    for (unsigned y = 45; y < 80; ++y) {
        for (unsigned x = 40; x < 120; ++x) {
            const osg::Vec4 pixel = image->getColor(x, y);
            green += pixel.g() > 1.1f * pixel.b() && pixel.g() > pixel.r();
        }
    }
    EXPECT_GT(green, 300); // the crown
}

/// Share of green pixels in a row. @param part position of the row, 0 (bottom) to 1 (top).
double greenInRow(const osg::Image& image, double part) {
    const auto y = static_cast<unsigned>(part * (image.t() - 1));
    int green = 0;
    for (int x = 0; x < image.s(); ++x) {
        const osg::Vec4 pixel = image.getColor(static_cast<unsigned>(x), y);
        green += pixel.g() > pixel.b();
    }
    return static_cast<double>(green) / image.s();
}

/// Expects a picture of an example from its default view. @param trees least share of trees along a row.
void expectSkyAboveTrees(const std::string& file, double trees) {
    const TemporaryFolder folder;
    const Outcome outcome =
        runTool({"render", example(file), "-o", "a.png", "--size", "320x180"}, folder.path());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const osg::ref_ptr<osg::Image> image = pictureIn(folder, "a.png");
    EXPECT_EQ(greenInRow(*image, 0.97), 0.0) << "sky";
    EXPECT_GT(greenInRow(*image, 0.4), trees);
    EXPECT_GT(greenInRow(*image, 0.05), 0.95) << "ground";
}

TEST(Render, TheDefaultViewIsAtEyeLevelWithSkyAboveTheForest) {
    expectSkyAboveTrees("forest.treewind", 0.3);
}

TEST(Render, TheDefaultViewOfTheCampusIsAtEyeLevelToo) {
    REQUIRE_REAL_DATA(inventory, "utah_campus/utah_campus_trees.csv");
    expectSkyAboveTrees("campus.treewind", 0.2);
}

TEST(Render, NamedViewsDifferAndEyeOverridesThem) {
    const TemporaryFolder folder;
    const auto view = [&](std::vector<std::string> options) {
        const std::string name = "a.png";
        EXPECT_EQ(render(folder, name, std::move(options)).exitCode, 0);
        return pictureIn(folder, name);
    };
    const auto eye = view({}), above = view({"--view", "above"}), portrait = view({"--view", "portrait"});
    EXPECT_EQ(meanDifference(*eye, *view({"--view", "eye"})), 0.0);
    EXPECT_GT(meanDifference(*eye, *above), 1.0);
    EXPECT_GT(meanDifference(*portrait, *above), 1.0);
    EXPECT_EQ(meanDifference(*view({"--eye", "0,-30,5"}), *view({"--eye", "0,-30,5", "--view", "portrait"})),
              0.0);
    EXPECT_EQ(render(folder, "a.png", {"--view", "below"}).exitCode, 2);
}

TEST(Render, TheSeasonOptionOverridesTheFile) {
    const TemporaryFolder folder;
    folder.write("a.treewind",
                 "version = 1\nseason = \"winter\"\n[[tree]]\nposition = [0, 0]\nspecies = \"oak\"\n");
    const auto draw = [&](std::vector<std::string> options) {
        options.insert(options.begin(), {"render", "a.treewind", "-o", "a.png", "--size", "160x90"});
        EXPECT_EQ(runTool(options, folder.path()).exitCode, 0);
        return pictureIn(folder, "a.png");
    };
    const auto winter = draw({}), summer = draw({"--season", "summer"});
    EXPECT_GT(meanDifference(*winter, *summer), 1.0);
    EXPECT_EQ(meanDifference(*winter, *draw({"--season", "2024-01-15"})), 0.0);
}

TEST(Render, APatternNumbersTheFramesFromZero) {
    const TemporaryFolder folder;
    EXPECT_EQ(render(folder, "f_%03d.png", {"--frames", "3", "--fps", "2"}).exitCode, 0);
    EXPECT_FALSE(std::filesystem::exists(folder.path() + "/f_003.png"));
    EXPECT_GT(meanDifference(*pictureIn(folder, "f_000.png"), *pictureIn(folder, "f_001.png")), 0.1);
    EXPECT_GT(meanDifference(*pictureIn(folder, "f_000.png"), *pictureIn(folder, "f_002.png")), 0.1);
}

TEST(Render, StartGivesTheSamePictureAsDrawingFromZero) {
    const TemporaryFolder folder;
    EXPECT_EQ(render(folder, "f_%d.png", {"--frames", "4", "--fps", "10"}).exitCode, 0);
    EXPECT_EQ(render(folder, "start.png", {"--start", "0.3", "--fps", "10"}).exitCode, 0);
    EXPECT_EQ(contentOf(folder.path() + "/f_3.png"), contentOf(folder.path() + "/start.png"));
}

TEST(Render, LooksStraightDown) {
    const TemporaryFolder folder;
    EXPECT_EQ(render(folder, "a.png", {"--eye", "0,0,20", "--center", "0,0,0"}).exitCode, 0);
    const osg::ref_ptr<osg::Image> image = pictureIn(folder, "a.png");
    ASSERT_EQ(image->s(), 160);
    const osg::Vec4 crown = image->getColor(80u, 45u), ground = image->getColor(2u, 2u);
    EXPECT_GT((crown - ground).length(), 0.02f);
}

TEST(Render, Mp4HasTheFramesAndSizeAskedFor) {
    if (runShell("ffmpeg -version && ffprobe -version").exitCode != 0)
        GTEST_SKIP() << "no ffmpeg here";
    const TemporaryFolder folder;
    const Outcome outcome = render(folder, "clip.mp4", {"--frames", "7", "--fps", "25"});
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    const Outcome probe = runShell("ffprobe -v error -count_frames -of csv=p=0 -show_entries "
                                   "stream=width,height,r_frame_rate,nb_read_frames clip.mp4",
                                   folder.path());
    EXPECT_EQ(probe.out, "160,90,25/1,7\n") << probe.err;
}

TEST(Render, Mp4ThatCannotBeWrittenIsExitCode1) {
    if (runShell("ffmpeg -version").exitCode != 0)
        GTEST_SKIP() << "no ffmpeg here";
    EXPECT_EQ(render(TemporaryFolder(), "absent/clip.mp4", {"--frames", "2"}).exitCode, 1);
}

TEST(Render, BothBackendsDrawTheSame) {
    if (!std::filesystem::exists(std::string(OSGTREEWIND_TOOL) + "-egl"))
        GTEST_SKIP() << "built with one backend";
    const TemporaryFolder folder;
    EXPECT_EQ(render(folder, "osmesa.png", {"--start", "0.5", "--backend", "osmesa"}).exitCode, 0);
    const Outcome egl = render(folder, "egl.png", {"--start", "0.5", "--backend", "egl"});
    EXPECT_EQ(egl.exitCode, 0) << egl.err;
    // Another renderer, such as a GPU, may differ at edges.
    EXPECT_LT(meanDifference(*pictureIn(folder, "osmesa.png"), *pictureIn(folder, "egl.png")), 1.0);
}

TEST(Render, EveryPoseOptionGivesTheSamePicture) {
    const TemporaryFolder folder;
    const std::vector<std::string> moving = {"--frames", "6", "--fps", "30", "--start", "1"};
    EXPECT_EQ(render(folder, "rest.png").exitCode, 0);
    EXPECT_EQ(render(folder, "cpu_%d.png", moving).exitCode, 0);
    const double moved = meanDifference(*pictureIn(folder, "rest.png"), *pictureIn(folder, "cpu_5.png"));
    EXPECT_GT(moved, 0.7);
    for (const std::string pose : {"gpu", "scenegraph"}) {
        std::vector<std::string> options = moving;
        options.insert(options.end(), {"--pose", pose});
        const Outcome outcome = render(folder, pose + "_%d.png", options);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        // gpu is one frame late; with scenegraph, leaves lack the shading of the crown.
        EXPECT_LT(meanDifference(*pictureIn(folder, "cpu_5.png"), *pictureIn(folder, pose + "_5.png")),
                  pose == "gpu" ? 0.2 * moved : 3.5)
            << pose;
    }
}
