// SPDX-License-Identifier: MIT
#include <tests/gl/GlTest.h>
#include <tests/nodes/ForestFixtures.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/species/Season.h>
#include <osgTreeWind/wind/FunctionWind.h>

using namespace osgTreeWind;

namespace {

/// Birches in a gust between 2 s and 4 s, which takes leaves in autumn.
ForestDescription birches(float impostorBelow, float season) {
    ForestDescription description = smallForest(3, 0.0f);
    description.species = {*findSpecies("silver birch")};
    for (TreePlacement& tree : description.trees) {
        tree.size.height = 10.0f;
        tree.openGrown = true;
    }
    description.wind = std::make_shared<FunctionWind>([](const glm::vec3&, double time) {
        return glm::vec3(time > 2.0 && time < 4.0 ? 30.0f : 0.0f, 0.0f, 0.0f);
    });
    description.season = season;
    description.drawing.full = 1.6f * impostorBelow;
    description.drawing.reduced = 1.5f * impostorBelow;
    description.drawing.impostor = impostorBelow;
    description.drawing.blend = 0.0f;
    description.damage = true;
    return description;
}

class ShedLeavesGlTest : public GlTest {
protected:
    /// Share of the picture that trees cover before and after the gust.
    std::pair<double, double> coveredAround(float impostorBelow, float season) {
        osg::ref_ptr<Forest> forest = new Forest(birches(impostorBelow, season));
        reopen(320, 200);
        viewer().setSceneData(forest);
        viewer().getCamera()->setProjectionMatrixAsPerspective(40, 1.6, 1, 100);
        viewer().getCamera()->setViewMatrixAsLookAt({4, -24, 5}, {4, 0, 5}, osg::Z_AXIS);
        frame(0.0);
        frame(1.0);
        const double before = covered(image());
        for (double time = 2.0; time < 18.0; time += 0.2)
            frame(time);
        return {before, covered(image())};
    }
};

} // namespace

TEST_F(ShedLeavesGlTest, AutumnGustThinsCrownsInEveryTier) {
    for (const float impostorBelow : {1.0f, 1000.0f}) { // with branches; impostors
        const auto [before, after] = coveredAround(impostorBelow, midautumn);
        EXPECT_GT(after, 0.02) << impostorBelow;
        EXPECT_LT(after, 0.93 * before) << impostorBelow;
    }
}

TEST_F(ShedLeavesGlTest, SummerGustKeepsCrowns) {
    for (const float impostorBelow : {1.0f, 1000.0f}) {
        const auto [before, after] = coveredAround(impostorBelow, midsummer);
        EXPECT_NEAR(after, before, 0.05 * before) << impostorBelow;
    }
}
