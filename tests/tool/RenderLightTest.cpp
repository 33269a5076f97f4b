// SPDX-License-Identifier: MIT
#include <tests/tool/Pictures.h>
#include <tests/tool/Tool.h>

#include <cmath>
#include <cstdlib>

namespace {

/// Renders a forest given as the text of a .treewind file.
osg::ref_ptr<osg::Image> renderForest(const std::string& forest, const std::vector<std::string>& options) {
    const TemporaryFolder folder;
    folder.write("a.treewind", "version = 1\n" + forest);
    std::vector<std::string> words = {"render", "a.treewind", "-o", "a.png", "--size", "96x54"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = runTool(words, folder.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return pictureIn(folder, "a.png");
}

/// Mean of a channel of a picture, 0 to 255.
double mean(const osg::Image& image, int channel) {
    double sum = 0.0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            sum += image.data(x, y)[channel];
    return sum / (image.s() * image.t());
}

std::string tree(const std::string& place) {
    return "[[tree]]\nposition = " + place + "\nheight = 12\nspecies = \"oak\"\nseed = 3\n";
}

/// View of the ground where the shadow of the crown falls with the default sun.
std::vector<std::string> onItsShadow(const std::string& shadows, const std::string& start = "0") {
    return {"--eye", "-5,5.6,40", "--center", "-5,5.6,0", "--fov",
            "4",     "--shadows", shadows,    "--start",  start};
}

} // namespace

TEST(RenderLight, OverlappingShadowsDoNotAddUp) {
    const double lit = mean(*renderForest(tree("[0, 0]"), onItsShadow("off")), 1),
                 one = mean(*renderForest(tree("[0, 0]"), onItsShadow("on")), 1),
                 three = mean(
                     *renderForest(tree("[0, 0]") + tree("[0.02, 0]") + tree("[0, 0.02]"), onItsShadow("on")),
                     1);
    EXPECT_LT(one, 0.85 * lit);
    EXPECT_GT(three, 0.93 * one);
    EXPECT_GT(three, 0.4 * lit) << "the sky still lights it";
}

TEST(RenderLight, ShadowsMoveWithTheirTrees) {
    const auto inWind = [](const std::string& speed) {
        return tree("[0, 0]") + "[wind]\nkind = \"uniform\"\nvelocity = [" + speed + ", 0, 0]\n";
    };
    const auto difference = [&](const std::string& speed) {
        return meanDifference(*renderForest(inWind(speed), onItsShadow("on")),
                              *renderForest(inWind(speed), onItsShadow("on", "3")));
    };
    EXPECT_EQ(difference("0"), 0.0);
    EXPECT_GT(difference("25"), 0.3);
}

TEST(RenderLight, SoftShadowsAreShadowsWithANote) {
    const TemporaryFolder folder;
    for (const std::string shadows : {"soft", "on"}) {
        const Outcome outcome = runTool({"render", example("forest.treewind"), "-o", shadows + ".png",
                                         "--size", "96x54", "--shadows", shadows},
                                        folder.path());
        EXPECT_EQ(outcome.exitCode, 0);
        EXPECT_EQ(outcome.err,
                  shadows == "soft" ? "--shadows soft: note: shadows are on; soft ones are gone\n" : "");
    }
    EXPECT_EQ(meanDifference(*pictureIn(folder, "soft.png"), *pictureIn(folder, "on.png")), 0.0);
}

TEST(RenderLight, ALowSunIsWarmAndDim) {
    const auto usual = renderForest(tree("[0, 0]"), {}),
               low = renderForest(tree("[0, 0]"), {"--sun", "250,8"});
    EXPECT_GT(mean(*low, 0) / mean(*low, 2), 1.1 * mean(*usual, 0) / mean(*usual, 2));
    EXPECT_LT(mean(*low, 1), 0.9 * mean(*usual, 1));
}

TEST(RenderLight, ATimeAndAPlaceGiveThePositionOfTheSun) {
    // The example of tests/tool/scene/SolarPositionTest.cpp.
    EXPECT_LT(meanDifference(
                  *renderForest(tree("[0, 0]"), {"--sun", "2003-10-17T12:30:30-07:00@39.742476,-105.1786"}),
                  *renderForest(tree("[0, 0]"), {"--sun", "194.34,39.89"})),
              0.3);
}

TEST(RenderLight, ASunBelowTheHorizonIsAnError) {
    const auto problemOf = [](const std::string& sun) {
        const Outcome outcome = runTool({"render", example("thesis.treewind"), "--sun", sun});
        EXPECT_EQ(outcome.exitCode, 2);
        return outcome.err;
    };
    EXPECT_NE(problemOf("90,-1").find(
                  "--sun: expected the sun above the horizon, found an elevation of -1 degrees"),
              std::string::npos);
    EXPECT_NE(problemOf("2026-07-01T23:00Z@52.5,13.4").find("above the horizon, found an elevation of -14"),
              std::string::npos);
    for (const char* bad : {"", "90", "90,100", "noon@52,13", "2026-07-01T12:00Z@99,0", "2026-07-01T12:00Z"})
        EXPECT_NE(
            problemOf(bad).find("--sun: expected AZIMUTH,ELEVATION in degrees or TIME@LATITUDE,LONGITUDE"),
            std::string::npos)
            << bad;
}

TEST(RenderLight, HazeHidesTheEdgeOfTheGround) {
    const auto image =
        renderForest(tree("[0, 0]"), {"--eye", "0,0,900", "--center", "0,6000,0", "--fov", "20"});
    for (int y = image->t() / 2 - 4; y < image->t() / 2 + 4; ++y) // the edge of the ground is in the middle
        for (int channel = 0; channel < 3; ++channel)
            EXPECT_NEAR(image->data(48, y)[channel], image->data(48, y - 1)[channel], 12) << y;
}

TEST(RenderLight, AnOvercastSkyIsGreyAndThrowsNoShadows) {
    const auto fair = renderForest(tree("[0, 0]"), {}),
               grey = renderForest(tree("[0, 0]"), {"--sky", "overcast"});
    const auto blueOf = [](const osg::Image& image) { // mean over the top row, which shows sky
        int sum = 0;
        for (int x = 0; x < image.s(); ++x)
            sum += image.data(x, image.t() - 1)[2] - image.data(x, image.t() - 1)[0];
        return sum / image.s();
    };
    EXPECT_GT(blueOf(*fair), 40);
    EXPECT_LT(blueOf(*grey), 20);
    const auto from = [](const char* shadows) {
        return std::vector<std::string>{"--sky", "overcast", "--shadows", shadows,
                                        "--eye", "0,-30,12", "--center",  "0,0,0"};
    };
    EXPECT_LT(
        meanDifference(*renderForest(tree("[0, 0]"), from("on")), *renderForest(tree("[0, 0]"), from("off"))),
        0.6);
}

TEST(RenderLight, ShadowMapsShadeOnlyTheGroundUnderTrees) {
    const auto seen = [](const char* shadows, const char* centre) {
        return renderForest(tree("[0, 0]"), {"--shadows", shadows, "--eye", "0,-20,9", "--center", centre});
    };
    EXPECT_LT(meanDifference(*seen("on", "0,-40,0"), *seen("off", "0,-40,0")), 1.0) << "in the open";
    EXPECT_GT(meanDifference(*seen("on", "0,0,0"), *seen("off", "0,0,0")), 1.5);
}

TEST(RenderLight, LitterLiesWhereCrownsClose) {
    std::string wood;
    for (int y = -12; y <= 12; y += 4)
        for (int x = -12; x <= 12; x += 4)
            wood += tree("[" + std::to_string(x) + ", " + std::to_string(y) + "]");
    const std::vector<std::string> low{"--eye", "2,2,1.5", "--center", "2,3,0", "--shadows", "off"};
    const auto green = [&](const std::string& trees) {
        const auto image = renderForest(trees, low);
        return mean(*image, 1) / mean(*image, 0);
    };
    EXPECT_LT(green(wood), 0.9 * green(tree("[300, 0]")));
}

TEST(RenderLight, SingleLeavesLieAtTheEdgeOfTheLitter) {
    const auto spread = [](const char* eye, const char* centre) { // of colours between green and orange
        const auto image = renderForest(tree("[0, 0]"), {"--season", "autumn", "--shadows", "off", "--eye",
                                                         eye, "--center", centre, "--fov", "30"});
        double sum = 0.0, squares = 0.0;
        for (int y = 0; y < image->t(); ++y)
            for (int x = 0; x < image->s(); ++x) {
                const double orange = image->data(x, y)[0] - image->data(x, y)[1];
                sum += orange;
                squares += orange * orange;
            }
        const int pixels = image->s() * image->t();
        return std::sqrt(squares / pixels - sum * sum / pixels / pixels);
    };
    EXPECT_GT(spread("0,-6,1.5", "0,-5,0"), 2.0 * spread("0,-300,1.5", "0,-299,0"));
}

TEST(RenderLight, TuftsOfGrassStandAroundTheEye) {
    const auto image =
        renderForest(tree("[0, 300]"), {"--eye", "0,0,0.12", "--center", "0,-10,0.12", "--fov", "5"});
    int green = 0; // number of green pixels above the horizon
    for (int y = image->t() / 2 + 1; y < image->t(); ++y)
        for (int x = 0; x < image->s(); ++x)
            green += image->data(x, y)[1] > image->data(x, y)[2];
    EXPECT_GT(green, 20);
    EXPECT_LT(green, 48 * 27);
}

TEST(RenderLight, AMissingGroundGoesThroughTheFeetOfTheTrees) {
    const auto low = renderForest(tree("[0, 0]"), {"--eye", "0,-20,1.7", "--center", "0,0,1.7"}),
               high = renderForest(tree("[0, 0, 30]"), {"--eye", "0,-20,31.7", "--center", "0,0,31.7"});
    EXPECT_LT(meanDifference(*low, *high), 3.0);
    const auto between = renderForest(tree("[0, 0, 30]") + tree("[10, 0, 32]") + tree("[-10, 0, 34]"),
                                      {"--eye", "5,-4,60", "--center", "5,0,30"});
    EXPECT_GT(mean(*between, 1), mean(*between, 2)) << "grass below";
}
