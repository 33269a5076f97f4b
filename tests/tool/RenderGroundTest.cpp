// SPDX-License-Identifier: MIT
#include <tests/tool/Pictures.h>
#include <tests/tool/Tool.h>

#include <cmath>
#include <sstream>

namespace {

/// Writes a forest on a slope that falls to the east by 50 %, 400 m wide, with one tree in its middle.
void writeForest(const TemporaryFolder& folder, const std::string& more) {
    std::ostringstream grid;
    grid << "ncols 40\nnrows 40\nxllcorner -200\nyllcorner -200\ncellsize 10\n";
    for (int row = 0; row < 40; ++row)
        for (int column = 0; column < 40; ++column)
            grid << 700 - 5 * column << (column < 39 ? ' ' : '\n');
    folder.write("slope.asc", grid.str());
    folder.write("a.treewind", "version = 1\n[[tree]]\nposition = [0, 0]\nheight = 12\n" + more);
}

osg::ref_ptr<osg::Image> renderSlope(const TemporaryFolder& folder, const std::string& output,
                                     std::vector<std::string> options) {
    options.insert(options.begin(), {"render", "a.treewind", "-o", output, "--size", "160x90"});
    const Outcome outcome = runTool(options, folder.path());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    return pictureIn(folder, output);
}

/// Number of rows from the bottom of a column that show grass (greener than blue).
int grassUpTo(const osg::Image& image, int column) {
    int row = 0;
    while (row < image.t() && image.data(column, row)[1] > image.data(column, row)[2])
        ++row;
    return row;
}

} // namespace

TEST(RenderGround, GrassLiesOnTheSlopeThatTheTreeStandsOn) {
    const TemporaryFolder folder;
    writeForest(folder, "[ground]\nfile = \"slope.asc\"\n");
    // From the south, just above the foot of the tree: the ground is high in the west and low in the east.
    const std::vector<std::string> view = {"--eye", "0,-60,606", "--center", "0,0,604"};
    const auto image = renderSlope(folder, "a.png", view);
    EXPECT_GT(grassUpTo(*image, 10), grassUpTo(*image, 150) + 20);
    renderSlope(folder, "b.png", view);
    EXPECT_EQ(contentOf(folder.path() + "/a.png"), contentOf(folder.path() + "/b.png"));
}

TEST(RenderGround, EveryViewIsAboveTheGround) {
    const TemporaryFolder folder;
    writeForest(folder, "[ground]\nfile = \"slope.asc\"\n");
    for (const char* view : {"eye", "above", "portrait"}) {
        const auto image = renderSlope(folder, "a.png", {"--view", view});
        const unsigned char* top = image->data(80, 89);
        EXPECT_GE(top[2], top[1]) << view << ": sky at the top of the picture";
        EXPECT_GT(grassUpTo(*image, 5), 3) << view;
    }
}

TEST(RenderGround, GroundNoneIsTheSameAsNoGround) {
    const TemporaryFolder folder;
    writeForest(folder, "");
    renderSlope(folder, "a.png", {});
    writeForest(folder, "[ground]\nnone = true\n");
    renderSlope(folder, "b.png", {});
    EXPECT_EQ(contentOf(folder.path() + "/a.png"), contentOf(folder.path() + "/b.png"));
}

TEST(RenderGround, ATreeOutsideTheGroundIsAnError) {
    const TemporaryFolder folder;
    writeForest(folder, "[[tree]]\nposition = [900, 0]\n[ground]\nfile = \"slope.asc\"\n");
    const Outcome outcome = runTool({"render", "a.treewind", "-o", "a.png"}, folder.path());
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_EQ(outcome.err,
              "a.treewind:8:8: ground.file: no ground below 1 of 2 trees, first tree[1] at (900, 0): "
              "the ground extends over x -200 to 200, y -200 to 200\n");
}
