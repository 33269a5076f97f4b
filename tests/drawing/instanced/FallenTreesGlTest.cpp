// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/motion/damage/TreeDamage.h>

using namespace osgTreeWind;

namespace {

/// A tree that falls after 20 s of a storm toward +x, across the view.
ForestDescription doomed(float pixels) {
    ForestDescription description = smallForest(1, 0.0f);
    description.species[0].wood.anchorage = 0.05f;
    description.trees[0].size.height = 10.0f;
    description.wind = std::make_shared<UniformWind>(glm::vec3(20.0f, 0.0f, 0.0f));
    description.drawing.full = 1.6f * pixels;
    description.drawing.reduced = 1.5f * pixels;
    description.drawing.impostor = pixels;
    description.drawing.blend = 0.0f;
    description.damage = true;
    return description;
}

class FallenTreesGlTest : public GlTest {
protected:
    /// @param zoom 2: only the lower right quarter of the view.
    osg::ref_ptr<osg::Image> picture(Forest* forest, double until, int zoom = 1) {
        open(160, 120);
        viewer().setSceneData(forest);
        osg::Camera& camera = *viewer().getCamera();
        camera.setProjectionMatrix(osg::Matrix::perspective(40, 4.0 / 3.0, 1, 100) *
                                   osg::Matrix::scale(zoom, zoom, 1) *
                                   osg::Matrix::translate(1 - zoom, zoom - 1, 0));
        camera.setViewport(160 - 160 / zoom, 0, 160 / zoom, 120 / zoom);
        camera.setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
        camera.setViewMatrixAsLookAt({3, -24, 5}, {3, 0, 4}, osg::Z_AXIS);
        for (double time = 0.0; time < until; time += 0.2)
            frame(time);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
    /// Share of the tree's pixels that lie above a row.
    static double above(const osg::Image& picture, int row) {
        int all = 0, high = 0;
        for (int y = 0; y < picture.t(); ++y)
            for (int x = 0; x < picture.s(); ++x)
                if (const unsigned char* p = picture.data(x, y); p[0] + p[1] + p[2] > 0) {
                    ++all;
                    high += y > row;
                }
        return all > 0 ? static_cast<double>(high) / all : -1.0;
    }
};

} // namespace

TEST_F(FallenTreesGlTest, FallenTreesLieInEveryTier) {
    for (const float pixels : {1.0f, 1000.0f}) { // with branches; impostor
        osg::ref_ptr<Forest> forest = new Forest(doomed(pixels));
        int told = 0;
        forest->setDamageCallback([&](const TreeDamage& damage) {
            ++told;
            EXPECT_EQ(damage.tree, forest->getTrees()[0]);
        });
        EXPECT_GT(above(*picture(forest, 1.0), 60), 0.3) << pixels;
        const osg::ref_ptr<osg::Image> down = picture(forest, 40.0);
        EXPECT_EQ(told, 1);
        EXPECT_GT(covered(*down), 0.01) << pixels;
        EXPECT_LT(above(*down, 60), 0.02) << pixels;
    }
}

TEST_F(FallenTreesGlTest, ImpostorsLieLikeTheTree) {
    const osg::ref_ptr<osg::Image> tree = picture(new Forest(doomed(1.0f)), 40.0),
                                   impostor = picture(new Forest(doomed(1000.0f)), 40.0);
    int both = 0, either = 0;
    for (int y = 0; y < tree->t(); y += 4) // blocks of 4 x 4 pixels, since crowns have gaps
        for (int x = 0; x < tree->s(); x += 4) {
            bool there[2] = {false, false};
            for (int i = 0; i < 16; ++i) {
                const unsigned char* a = tree->data(x + i % 4, y + i / 4);
                const unsigned char* b = impostor->data(x + i % 4, y + i / 4);
                there[0] = there[0] || a[0] + a[1] + a[2] > 0;
                there[1] = there[1] || b[0] + b[1] + b[2] > 0;
            }
            both += there[0] && there[1];
            either += there[0] || there[1];
        }
    EXPECT_GT(either, 20);
    EXPECT_GT(static_cast<double>(both) / either, 0.7);
}

TEST_F(FallenTreesGlTest, DamageCallbackMayRemoveFallenTrees) {
    osg::ref_ptr<Forest> forest = new Forest(doomed(1.0f));
    forest->setDamageCallback(
        [&](const TreeDamage& damage) { EXPECT_TRUE(forest->removeTree(damage.tree).empty()); });
    const osg::ref_ptr<osg::Image> empty = picture(forest, 40.0);
    EXPECT_EQ(forest->getNumTrees(), 0u);
    EXPECT_EQ(covered(*empty), 0.0);
}

TEST_F(FallenTreesGlTest, PartsAreDrawnWhereTheyLie) { // not where they stood
    for (const double until : {20.4, 40.0}) {          // in the fall; afterwards
        const osg::ref_ptr<osg::Image> wide = picture(new Forest(doomed(1.0f)), until),
                                       crown = picture(new Forest(doomed(1.0f)), until, 2);
        EXPECT_GT(covered(*crown), 0.02);
        int different = 0;
        for (int y = 0; y < 60; ++y)
            for (int x = 0; x < 80; ++x)
                different += std::abs(int(crown->data(x, y)[1]) - int(wide->data(80 + x, y)[1])) > 2;
        EXPECT_LT(different, 10);
    }
}
