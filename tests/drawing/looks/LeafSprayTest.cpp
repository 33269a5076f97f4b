// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/LeafSpray.h>

#include <osgTreeWind/drawing/looks/TreeTextures.h>
#include <osgTreeWind/species/LeafCoverage.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int twigs = 2, all = 3;
constexpr int forms = static_cast<int>(LeafForm::Frond) + 1;

/// Share of a level of the image that the alpha test keeps.
float coverage(const osg::Image& image, unsigned level, int channel) {
    const int texels = (image.s() >> level) * (image.t() >> level);
    const unsigned char* data = level ? image.getMipmapData(level) : image.data();
    int kept = 0;
    for (int i = 0; i < texels; ++i)
        kept += data[4 * i + channel] >= 128;
    return static_cast<float>(kept) / static_cast<float>(texels);
}

} // namespace

class LeafSprayOf : public testing::TestWithParam<int> {
protected:
    LeafForm form() const { return static_cast<LeafForm>(GetParam()); }
    Appearance appearance() const {
        Appearance appearance;
        appearance.leafForm = form();
        return appearance;
    }
};

TEST_P(LeafSprayOf, CoversWhatMechanicsCountOn) {
    const osg::ref_ptr<osg::Image> image = leafImage(appearance());
    const float bare = coverage(*image, 0, twigs);
    EXPECT_NEAR(bare, twigCoverage(form()), 0.005f);
    EXPECT_NEAR(coverage(*image, 0, all) - bare, leafCoverage(form()), 0.01f);
}

TEST_P(LeafSprayOf, SpringsFromTheMiddleOfItsLowerEdge) {
    const LeafTexels spray = paintSpray(form());
    float foot = 0.0f, elsewhere = 0.0f;
    for (int x = 0; x < spray.size; ++x)
        (std::abs(x - spray.size / 2) < spray.size / 16 ? foot : elsewhere) += spray.at(x, 1).b;
    EXPECT_GT(foot, 0.5f);
    EXPECT_EQ(elsewhere, 0.0f);
}

TEST_P(LeafSprayOf, DoesNotShowTheCard) {
    const LeafTexels spray = paintSpray(form());
    const int last = spray.size - 1;
    for (int i = 0; i <= last; ++i) {
        EXPECT_LT(spray.at(0, i).a + spray.at(last, i).a, 0.7f) << i;
        if (i < spray.size / 8 || i > last - spray.size / 8) {
            EXPECT_EQ(spray.at(i, 0).a + spray.at(i, last).a, 0.0f) << i;
        }
    }
}

TEST_P(LeafSprayOf, KeepsItsCoverageInSmallerLevels) {
    const osg::ref_ptr<osg::Image> image = leafImage(appearance());
    ASSERT_EQ(image->getNumMipmapLevels(), 9u);
    for (unsigned level = 1; level <= 5; ++level) {
        EXPECT_NEAR(coverage(*image, level, all), coverage(*image, 0, all), 0.05f) << level;
        EXPECT_NEAR(coverage(*image, level, twigs), coverage(*image, 0, twigs), 0.02f) << level;
    }
    EXPECT_EQ(coverage(*image, 8, twigs), 0.0f); // a bare crown is no solid one far away
}

TEST_P(LeafSprayOf, ShowsItsTwigsAmongItsLeaves) {
    const LeafTexels spray = paintSpray(form());
    for (const glm::vec4& texel : spray.texels)
        ASSERT_LE(texel.b, texel.a);
}

INSTANTIATE_TEST_SUITE_P(Forms, LeafSprayOf, testing::Range(0, forms));

TEST(LeafSpray, EveryFormLooksDifferent) {
    for (int a = 0; a < forms; ++a)
        for (int b = 0; b < a; ++b) {
            const LeafTexels one = paintSpray(static_cast<LeafForm>(a)),
                             other = paintSpray(static_cast<LeafForm>(b));
            double apart = 0.0;
            for (std::size_t i = 0; i < one.texels.size(); ++i)
                apart += std::abs(one.texels[i].a - other.texels[i].a);
            EXPECT_GT(apart / static_cast<double>(one.texels.size()), 0.15) << a << ", " << b;
        }
}
