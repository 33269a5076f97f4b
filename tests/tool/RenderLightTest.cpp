// SPDX-License-Identifier: MIT
#include <tests/tool/Tool.h>

#include <osgDB/ReadFile>

namespace {

/// A picture of a forest that stands in a file's text.
osg::ref_ptr<osg::Image> render(const std::string& forest, const std::vector<std::string>& options) {
    const TemporaryFolder folder;
    folder.write("a.treewind", "version = 1\n" + forest);
    std::vector<std::string> words = {"render", "a.treewind", "-o", "a.png", "--size", "96x54"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = runTool(words, folder.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    osg::ref_ptr<osg::Image> image = osgDB::readRefImageFile(folder.path() + "/a.png");
    EXPECT_TRUE(image);
    return image ? image : osg::ref_ptr<osg::Image>(new osg::Image);
}

/// Mean of a channel, 0 to 255. @param upper only of the upper half.
double mean(const osg::Image& image, int channel, bool upper = false) {
    double sum = 0.0;
    const int first = upper ? image.t() / 2 : 0;
    for (int y = first; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x)
            sum += image.data(x, y)[channel];
    return sum / (image.s() * (image.t() - first));
}

std::string tree(const std::string& place) {
    return "[[tree]]\nposition = " + place + "\nheight = 12\nspecies = \"oak\"\nseed = 3\n";
}

/// Ground only, where the shadow of a tree's crown falls while nobody moves the sun.
std::vector<std::string> onItsShadow(const std::string& shadows, const std::string& start = "0") {
    return {"--eye", "-5,5.6,40", "--center", "-5,5.6,0", "--fov",
            "4",     "--shadows", shadows,    "--start",  start};
}

} // namespace

TEST(RenderLight, SoftShadowsTakeTheSunOnceHoweverManyOverlap) {
    const double lit = mean(*render(tree("[0, 0]"), onItsShadow("off")), 1),
                 one = mean(*render(tree("[0, 0]"), onItsShadow("soft")), 1),
                 three = mean(
                     *render(tree("[0, 0]") + tree("[0.02, 0]") + tree("[0, 0.02]"), onItsShadow("soft")), 1);
    EXPECT_LT(one, 0.85 * lit);
    EXPECT_GT(three, 0.93 * one);
    EXPECT_GT(three, 0.4 * lit) << "the sky still lights it";
}

TEST(RenderLight, SoftShadowsLeanWithTheirTrees) {
    const auto inWind = [](const std::string& speed) {
        return tree("[0, 0]") + "[wind]\nkind = \"uniform\"\nvelocity = [" + speed + ", 0, 0]\n";
    };
    const auto difference = [&](const std::string& speed) {
        const auto first = render(inWind(speed), onItsShadow("soft")),
                   later = render(inWind(speed), onItsShadow("soft", "3"));
        double sum = 0.0;
        for (unsigned i = 0; i < first->getTotalSizeInBytes(); ++i)
            sum += std::abs(first->data()[i] - later->data()[i]);
        return sum / first->getTotalSizeInBytes();
    };
    EXPECT_EQ(difference("0"), 0.0);
    EXPECT_GT(difference("25"), 0.5);
}
