// SPDX-License-Identifier: MIT
// Pictures of a tiled forest in a viewer, compared with the same forest without tiles.
#include <osgTreeWind/io/ForestFile.h>
#include <osgTreeWind/io/TiledForest.h>
#include <osgTreeWind/nodes/Forest.h>
#include <tests/gl/GlTest.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/nodes/Pictures.h>

#include <chrono>
#include <sstream>
#include <thread>

using namespace osgTreeWind;

namespace {

/// A wood on a square kilometre about (0, 0), of trees with the same sizes as in a tiled forest.
ForestDescription wood() {
    std::istringstream text("version = 1\n[wind]\nkind = \"calm\"\n"
                            "[[scatter]]\ncount = 6000\narea = [-500.0, -500.0, 500.0, 500.0]\n"
                            "species = [\"oak\", \"Norway spruce\"]\nheight = [16.2, 16.6]\n"
                            "open_grown = true\n");
    return readForest(text).value();
}

/// Mean brightness of the pixels that are not black.
double brightness(const osg::Image& image) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < image.s() * image.t(); ++i) {
        const unsigned char* pixel = image.data() + 4 * i;
        const int all = pixel[0] + pixel[1] + pixel[2];
        sum += all / 3.0;
        count += all > 0;
    }
    return sum / count;
}

class TilePagerGlTest : public GlTest {
protected:
    static constexpr int width = 240, height = 180;

    osg::ref_ptr<Forest> tiled(const ForestDescription& forest, double range) {
        TilingOptions options;
        options.size = 250.0;
        options.range = range;
        EXPECT_TRUE(writeTiledForest(forest, _folder.path(), options));
        return new Forest(readForestFile(_folder.path() + "/world.treewind").value());
    }

    /// The picture ten frames after all trees are loaded. @param trees expected.
    osg::ref_ptr<osg::Image> picture(Forest* forest, const osg::Vec3d& eye, std::size_t trees) {
        open(width, height);
        viewer().setSceneData(forest);
        osg::Camera& camera = *viewer().getCamera();
        camera.setClearColor(osg::Vec4(0, 0, 0, 1));
        camera.setProjectionMatrixAsPerspective(40, double(width) / height, 1, 5000);
        const osg::Vec3d middle = -forest->getOrigin();
        camera.setViewMatrixAsLookAt(middle + eye, middle, osg::Y_AXIS);
        for (int i = 0; i < 400 && forest->getNumTrees() < trees; ++i)
            wait();
        EXPECT_EQ(forest->getNumTrees(), trees);
        for (int i = 0; i < 10; ++i)
            wait();
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }

private:
    void wait() {
        frame(0.0);
        std::this_thread::sleep_for(std::chrono::milliseconds(5)); // for the pager's thread
    }

    TemporaryFolder _folder;
};

} // namespace

TEST_F(TilePagerGlTest, FourTilesLookLikeTheUntiledForest) {
    const ForestDescription forest = wood();
    for (const osg::Vec3d& eye : {osg::Vec3d(0, 0, 160), osg::Vec3d(0, -90, 40)}) {
        const osg::ref_ptr<osg::Image> whole = picture(new Forest(forest), eye, 6000),
                                       tiles = picture(tiled(forest, 2000.0), eye, 6000);
        EXPECT_GT(covered(*whole), 0.1);
        EXPECT_LT(difference(*whole, *tiles).mean, 0.05);
    }
}

TEST_F(TilePagerGlTest, FarCrownsMatchTheCoverAndBrightnessOfTheirTrees) {
    const ForestDescription forest = wood();
    for (const osg::Vec3d& eye : {osg::Vec3d(0, 0, 2000), osg::Vec3d(0, -1800, 600)}) {
        const osg::ref_ptr<osg::Image> trees = picture(new Forest(forest), eye, 6000),
                                       crowns = picture(tiled(forest, 10.0), eye, 0);
        EXPECT_NEAR(covered(*crowns) / covered(*trees), 1.0, 0.25);
        EXPECT_NEAR(brightness(*crowns) / brightness(*trees), 1.0, 0.1);
    }
}
