// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

using namespace osgTreeWind;

namespace {

class SpeciesLooksGlTest : public GlTest {
protected:
    /// A tree with nearly horizontal leaves in a wind, seen from a height.
    osg::ref_ptr<osg::Image> picture(float underside, float eyeHeight, float speed = 0.0f) {
        Species species = smallSpecies();
        species.tree.leaves.clusters = 400;
        species.tree.leaves.inclination = 0.3f;
        species.leaf.maxDownwind = 1.0f;
        species.appearance.underside = underside;
        ForestDescription description = oneTree(species, speed);
        description.drawing.tiers = false;
        reopen(160, 160);
        viewer().setSceneData(new Forest(description));
        viewer().getCamera()->setProjectionMatrixAsPerspective(40, 1, 0.1, 200);
        viewer().getCamera()->setViewMatrixAsLookAt(osg::Vec3(1.5f, 1, eyeHeight), osg::Vec3(0, 0, 5),
                                                    osg::Y_AXIS);
        for (int i = 0; i < 20; ++i)
            frame(i / 25.0);
        return new osg::Image(image(), osg::CopyOp::DEEP_COPY_ALL);
    }
    static double brightness(const osg::Image& image) {
        double sum = 0.0;
        for (int i = 0; i < image.s() * image.t(); ++i)
            sum += image.data()[4 * i] + image.data()[4 * i + 1] + image.data()[4 * i + 2];
        return sum / (3.0 * image.s() * image.t());
    }
};

} // namespace

TEST_F(SpeciesLooksGlTest, CrownsArePalerFromBelow) {
    EXPECT_GT(brightness(*picture(2.0f, 0.2f)), 1.05 * brightness(*picture(1.0f, 0.2f)));
    EXPECT_LT(brightness(*picture(2.0f, 20.0f)), 0.97 * brightness(*picture(1.0f, 20.0f)))
        << "the leaf colour is the mean of both sides";
}

TEST_F(SpeciesLooksGlTest, WindTurnsUndersidesUp) {
    const auto paler = [&](float speed) {
        return brightness(*picture(2.0f, 20.0f, speed)) / brightness(*picture(1.0f, 20.0f, speed));
    };
    EXPECT_GT(paler(15.0f), paler(0.0f) + 0.01);
}
