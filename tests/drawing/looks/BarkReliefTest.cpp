// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/BarkRelief.h>

#include <osgTreeWind/motion/laws/Laws.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int forms = static_cast<int>(BarkForm::Scaly) + 1;
constexpr int oldBark = 0, youngBark = 3; // channels

/// Mean difference of a channel between a row and the next row, or between a column and the next column.
double step(const osg::Image& image, bool across, int line, int channel) {
    const int length = across ? image.t() : image.s(), lines = across ? image.s() : image.t();
    const auto value = [&](int i, int j) {
        return across ? image.data(i, j)[channel] : image.data(j, i)[channel];
    };
    double sum = 0.0;
    for (int j = 0; j < length; ++j)
        sum += std::abs(value(line, j) - value((line + 1) % lines, j));
    return sum / length;
}

/// Mean standard deviation of a channel along rows or along columns.
double variation(const osg::Image& image, bool across, int channel) {
    const int lines = across ? image.t() : image.s(), length = across ? image.s() : image.t();
    double total = 0.0;
    for (int line = 0; line < lines; ++line) {
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < length; ++i) {
            const double value = (across ? image.data(i, line) : image.data(line, i))[channel];
            sum += value;
            squares += value * value;
        }
        total += std::sqrt(std::max(squares / length - sum * sum / length / length, 0.0));
    }
    return total / lines;
}

} // namespace

TEST(BarkRelief, IsSeamless) {
    for (int form = 0; form < forms; ++form) {
        const osg::ref_ptr<osg::Image> image = paintBark(static_cast<BarkForm>(form));
        for (const bool across : {false, true})
            for (int channel = 0; channel < 4; ++channel) {
                const int last = (across ? image->s() : image->t()) - 1;
                double largest = 0.0;
                for (int line = 0; line < last; ++line)
                    largest = std::max(largest, step(*image, across, line, channel));
                EXPECT_LE(step(*image, across, last, channel), largest)
                    << form << ", " << channel << (across ? " around" : " along");
            }
    }
}

TEST(BarkRelief, OldAndYoungBarkOfAllFormsHaveTheSameMeanBrightness) {
    for (int form = 0; form < forms; ++form)
        for (const int channel : {oldBark, youngBark}) {
            const osg::ref_ptr<osg::Image> image = paintBark(static_cast<BarkForm>(form));
            double sum = 0.0;
            for (int i = 0; i < image->s() * image->t(); ++i)
                sum += image->data()[4 * i + channel] / 255.0;
            EXPECT_NEAR(sum / (image->s() * image->t()), 0.75, 0.02) << form << ", " << channel;
        }
}

// Furrows are dark because light seldom gets there, which the shader computes, and not because they are
// black.
TEST(BarkRelief, FurrowsAreNotPaintedBlack) {
    for (int form = 0; form < forms; ++form) {
        const osg::ref_ptr<osg::Image> image = paintBark(static_cast<BarkForm>(form));
        for (int i = 0; i < image->s() * image->t(); ++i)
            ASSERT_GT(image->data()[4 * i + oldBark], 100) << form;
    }
}

TEST(BarkRelief, FurrowsRunAlongAndBandsAndRingsAcross) {
    const auto ratio = [](BarkForm form, int channel) {
        const osg::ref_ptr<osg::Image> image = paintBark(form);
        return variation(*image, true, channel) / variation(*image, false, channel);
    };
    EXPECT_GT(ratio(BarkForm::Furrowed, oldBark), 1.02);
    EXPECT_LT(ratio(BarkForm::Banded, youngBark), 0.95);
    EXPECT_LT(ratio(BarkForm::Ringed, youngBark), 0.95);
}

TEST(BarkRelief, BeechesAreTheSmoothest) {
    const auto roughness = [](BarkForm form) { return variation(*paintBark(form), true, oldBark); };
    for (int form = 0; form < forms; ++form)
        if (static_cast<BarkForm>(form) != BarkForm::Smooth) {
            EXPECT_GT(roughness(static_cast<BarkForm>(form)), roughness(BarkForm::Smooth)) << form;
        }
}

TEST(BarkRelief, YoungBarkIsSmootherThanOldBark) {
    for (const BarkForm form : {BarkForm::Furrowed, BarkForm::Plated, BarkForm::Scaly}) {
        const osg::ref_ptr<osg::Image> image = paintBark(form);
        EXPECT_LT(variation(*image, true, youngBark), variation(*image, true, oldBark))
            << static_cast<int>(form);
    }
}

TEST(BarkRelief, BarkIsOldAtTheFootOfThickStemsAndYoungOnBoughs) {
    for (int form = 0; form < forms; ++form) {
        const glm::vec3 ageing = barkAgeing(static_cast<BarkForm>(form));
        EXPECT_GT(Laws().barkAge(0.45f, 0.0f, ageing), 0.9f) << form;
        EXPECT_LT(Laws().barkAge(0.03f, 12.0f, ageing), 0.1f) << form;
        EXPECT_GE(Laws().barkAge(0.2f, 0.0f, ageing), Laws().barkAge(0.2f, 5.0f, ageing)) << form;
    }
    const auto age = [](BarkForm form, float radius, float height) {
        return Laws().barkAge(radius, height, barkAgeing(form));
    };
    EXPECT_GT(age(BarkForm::Furrowed, 0.2f, 8.0f), 0.9f) << "oaks are rough up to the crown";
    EXPECT_GT(age(BarkForm::Plated, 0.2f, 1.0f), 0.9f) << "pines have plates below";
    EXPECT_LT(age(BarkForm::Plated, 0.12f, 9.0f), 0.1f) << "and flakes above";
    EXPECT_LT(age(BarkForm::Banded, 0.15f, 3.0f), 0.1f) << "birches are white above their foot";
    EXPECT_LT(age(BarkForm::Smooth, 0.2f, 1.0f), 0.3f) << "beeches stay smooth for long";
}

TEST(BarkRelief, CracksOpenWhileRidgesAreStillSmooth) {
    EXPECT_EQ(Laws().oldShare(0.0f, 0.0f), 0.0f);
    EXPECT_EQ(Laws().oldShare(1.0f, 1.0f), 1.0f);
    EXPECT_GT(Laws().oldShare(0.4f, 0.1f), Laws().oldShare(0.4f, 0.7f));
}
