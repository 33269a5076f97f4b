// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/io/TemporaryFolder.h>
#include <tests/model/SampleTree.h>
#include <tests/nodes/ForestFixtures.h>

#include <osgDB/WriteFile>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

using namespace osgTreeWind;

namespace {

/// A bare pole on a black background.
class BarkReliefGlTest : public GlTest {
protected:
    static constexpr int size = 128;

    /// @param width of the picture, metres. @param file bark image.
    osg::ref_ptr<osg::Image> pole(BarkForm form, float radius, double width, const std::string& file = {}) {
        PalmParameters wood = barePole(4.0f);
        wood.trunkDiameter = 2.0f * radius;
        wood.trunkTaper = 1.0f;
        wood.trunkCrook = wood.flare = 0.0f;
        Species species = smallSpecies();
        species.tree.palm = wood;
        species.tree.leaves.clustersPerBranch = 0;
        species.appearance.bark = glm::vec3(0.7f);
        species.appearance.barkForm = form;
        species.appearance.barkImage = file;
        reopen(size, size);
        ForestDescription forest = oneTree(species, 0.0f);
        forest.drawing.tiers = false;
        viewer().setSceneData(new Forest(std::move(forest)));
        osg::Camera& camera = *viewer().getCamera();
        camera.setProjectionMatrixAsPerspective(2.0 * osg::RadiansToDegrees(std::atan(0.5 * width / 5.0)),
                                                1.0, 1.0, 20.0);
        viewer().getLight()->setPosition(osg::Vec4(1, 0.5f, 1, 0)); // in the camera's frame
        return poleFrom(0.0);
    }

    /// The same pole from another side. @param side angle around the pole, radians.
    osg::ref_ptr<osg::Image> poleFrom(double side) {
        const osg::Vec3d eye(5.0 * std::sin(side), -5.0 * std::cos(side), 2.0);
        viewer().getCamera()->setViewMatrixAsLookAt(eye, osg::Vec3d(0, 0, 2), osg::Vec3d(0, 0, 1));
        frame(0.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
};

int brightness(const osg::Image& image, int x, int y) {
    return image.data(x, y)[1];
}

} // namespace

TEST_F(BarkReliefGlTest, BirchStemsAreBrighterThanTwigs) {
    const auto mean = [](const osg::Image& image) {
        int sum = 0;
        for (int y = 0; y < size; ++y)
            sum += brightness(image, size / 2, y);
        return sum / size;
    };
    const int stem = mean(*pole(BarkForm::Banded, 0.1f, 1.0)),
              twig = mean(*pole(BarkForm::Banded, 0.006f, 0.04));
    EXPECT_GT(stem, 70);
    EXPECT_GT(twig, 0) << "no twig is visible";
    EXPECT_LT(twig, stem / 2);
}

TEST_F(BarkReliefGlTest, BirchesAreBlackAtTheFoot) {
    const osg::ref_ptr<osg::Image> stem = pole(BarkForm::Banded, 0.35f, 4.0);
    const auto mean = [&](int low, int high) {
        int sum = 0;
        for (int y = low; y < high; ++y)
            sum += brightness(*stem, size / 2, y);
        return sum / (high - low);
    };
    EXPECT_LT(mean(4, 24), mean(90, 124) / 2);
}

// GPUs compute derivatives for blocks of 2 x 2 pixels. Relief made of them alone changes at every second
// pixel.
TEST_F(BarkReliefGlTest, IsFineAndSmoothInCloseUp) {
    const osg::ref_ptr<osg::Image> bark = pole(BarkForm::Furrowed, 0.3f, 0.15);
    int within = 0, across = 0;
    for (int y = 0; y < size; ++y)
        for (int x = 0; x + 2 < size; x += 2) {
            within += std::abs(brightness(*bark, x + 1, y) - brightness(*bark, x, y));
            across += std::abs(brightness(*bark, x + 2, y) - brightness(*bark, x + 1, y));
        }
    EXPECT_GT(within, 30000) << "fine relief is missing, which more than doubles this value";
    EXPECT_LT(across, 1.2 * within);
}

// Around the pole, brightness changes once from light to dark and once from dark to light. At a seam, the
// whole texture would repeat between two vertices.
TEST_F(BarkReliefGlTest, IsSeamlessAroundABranch) {
    const TemporaryFolder folder;
    const osg::ref_ptr<osg::Image> halves = new osg::Image;
    halves->allocateImage(64, 64, 1, GL_RGB, GL_UNSIGNED_BYTE);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            std::fill_n(halves->data(static_cast<unsigned>(x), static_cast<unsigned>(y)), 3,
                        x < 32 ? 255 : 0);
    const std::string file = folder.path() + "/halves.png";
    ASSERT_TRUE(osgDB::writeImageFile(*halves, file));
    pole(BarkForm::Furrowed, 0.15f, 0.45, file);
    constexpr int sides = 90;
    std::vector<bool> light;
    for (int i = 0; i < sides; ++i) {
        const double side = (i + 0.3) * 2.0 * osg::PI / sides;
        light.push_back(brightness(*poleFrom(side), size / 2, size / 2) > 50);
    }
    int changes = 0, lit = 0;
    for (std::size_t i = 0; i < sides; ++i) {
        changes += light[i] != light[(i + 1) % sides];
        lit += light[i];
    }
    EXPECT_EQ(changes, 2);
    EXPECT_NEAR(lit, sides / 2, 3);
}

TEST_F(BarkReliefGlTest, PolesThinnerThanAPixelCoverTheirShareOfIt) {
    for (const float share : {0.25f, 0.5f, 0.75f}) {
        constexpr double width = 12.0;
        const float radius = 0.5f * share * static_cast<float>(width) / size;
        const osg::ref_ptr<osg::Image> picture = pole(BarkForm::Smooth, radius, width);
        int rows = 0, drawn = 0, longestGap = 0, gap = 0;
        for (int y = size / 2 - 18; y < size / 2 + 18; ++y) { // within the height of the pole
            int inRow = 0;
            for (int x = 0; x < size; ++x)
                inRow += brightness(*picture, x, y) > 0;
            ++rows;
            drawn += inRow;
            gap = inRow > 0 ? 0 : gap + 1;
            longestGap = std::max(longestGap, gap);
        }
        EXPECT_NEAR(drawn / static_cast<double>(rows), share, 0.12) << share;
        EXPECT_LT(longestGap, 6.0 / static_cast<double>(share)) << share;
    }
}
