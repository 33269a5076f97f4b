// SPDX-License-Identifier: MIT
// Pictures of seasons, in each way of drawing.
#include <tests/gl/GlTest.h>
#include <tests/nodes/Pictures.h>

#include <osgTreeWind/forest/ForestDescription.h>
#include <osgTreeWind/io/SpeciesCatalogue.h>
#include <osgTreeWind/nodes/Forest.h>
#include <osgTreeWind/wind/UniformWind.h>

#include <memory>

using namespace osgTreeWind;

namespace {

enum class SeasonWay { Branches, Impostors, Branchwise };

osg::ref_ptr<Forest> tree(const char* species, SeasonWay way, float season) {
    ForestDescription forest;
    forest.species = {*findSpecies(species)};
    forest.species[0].shapes = 1;
    forest.trees.emplace_back().openGrown = true;
    forest.wind = std::make_shared<UniformWind>(glm::vec3(0.0f));
    forest.law = way == SeasonWay::Branchwise ? MotionLaw::ThesisSmooth : MotionLaw::Modal;
    forest.season = season;
    if (way == SeasonWay::Impostors)
        forest.drawing.full = 3e4f, forest.drawing.reduced = 2e4f, forest.drawing.impostor = 1e4f;
    else
        forest.drawing.tiers = false;
    return new Forest(std::move(forest));
}

/// Sum of red over the sum of red and green.
double redness(const osg::Image& image) {
    double red = 0.0, green = 0.0;
    for (int i = 0; i < image.s() * image.t(); ++i) {
        red += image.data()[4 * i];
        green += image.data()[4 * i + 1];
    }
    return red / (red + green);
}

class SeasonGlTest : public GlTest {
protected:
    osg::ref_ptr<osg::Image> picture(osg::Node* node) { return render(node, 240, 240, 2); }
};

constexpr SeasonWay ways[] = {SeasonWay::Branches, SeasonWay::Impostors, SeasonWay::Branchwise};

} // namespace

TEST_F(SeasonGlTest, ABroadleafLosesItsLeavesAndKeepsItsTwigs) {
    for (const SeasonWay way : ways) {
        const double summer = covered(*picture(tree("oak", way, midsummer)));
        const double autumn = covered(*picture(tree("oak", way, midautumn)));
        const double winter = covered(*picture(tree("oak", way, midwinter)));
        EXPECT_LT(winter, 0.75 * summer) << static_cast<int>(way);
        EXPECT_GT(winter, 0.15 * summer) << static_cast<int>(way);
        EXPECT_LT(winter, autumn) << static_cast<int>(way);
        EXPECT_LT(autumn, summer) << static_cast<int>(way);
    }
}

TEST_F(SeasonGlTest, LeavesTurnRed) {
    for (const SeasonWay way : ways) {
        const osg::ref_ptr<osg::Image> summer = picture(tree("oak", way, midsummer)),
                                       autumn = picture(tree("oak", way, midautumn));
        EXPECT_LT(redness(*summer), 0.49) << static_cast<int>(way);
        EXPECT_GT(redness(*autumn), 0.53) << static_cast<int>(way);
    }
}

TEST_F(SeasonGlTest, AnEvergreenDoesNotChange) {
    for (const SeasonWay way : ways) {
        const osg::ref_ptr<osg::Image> summer = picture(tree("Norway spruce", way, midsummer)),
                                       winter = picture(tree("Norway spruce", way, midwinter));
        EXPECT_EQ(difference(*summer, *winter).mean, 0.0) << static_cast<int>(way);
    }
}

TEST_F(SeasonGlTest, SetSeasonGivesThePictureOfAForestMadeInThatSeason) {
    for (const SeasonWay way : ways) {
        const osg::ref_ptr<Forest> forest = tree("oak", way, midsummer);
        const osg::ref_ptr<osg::Image> summer = picture(forest);
        for (const float season : {midautumn, midwinter, midsummer}) {
            EXPECT_TRUE(forest->setSeason(season).empty());
            EXPECT_EQ(forest->getSeason(), season);
            const osg::ref_ptr<Forest> made = tree("oak", way, season);
            picture(made); // the first frame updates the bound
            const double most = way == SeasonWay::Branchwise ? 0.5 : 0.05; // goes on swaying
            EXPECT_LT(difference(*picture(forest), *picture(made)).mean, most)
                << static_cast<int>(way) << ", " << season;
        }
        if (way != SeasonWay::Branchwise) { // the first picture had another bound
            EXPECT_LT(difference(*picture(forest), *summer).mean, 0.05) << static_cast<int>(way);
        }
    }
}

TEST_F(SeasonGlTest, ACopyHasItsOwnSeason) {
    const osg::ref_ptr<Forest> forest = tree("oak", SeasonWay::Impostors, midautumn);
    const osg::ref_ptr<Forest> copy = osg::clone(forest.get());
    EXPECT_EQ(copy->getSeason(), midautumn);
    const osg::ref_ptr<osg::Image> before = picture(copy);
    EXPECT_TRUE(forest->setSeason(midsummer).empty());
    EXPECT_EQ(copy->getSeason(), midautumn);
    EXPECT_LT(difference(*picture(copy), *before).mean, 0.05);
    EXPECT_GT(difference(*picture(forest), *before).mean, 0.5);
}
