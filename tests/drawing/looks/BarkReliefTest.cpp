// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/BarkRelief.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int forms = static_cast<int>(BarkForm::Scaly) + 1;

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

/// Mean standard deviation of the brightness along rows or along columns.
double variation(const osg::Image& image, bool across) {
    const int lines = across ? image.t() : image.s(), length = across ? image.s() : image.t();
    double total = 0.0;
    for (int line = 0; line < lines; ++line) {
        double sum = 0.0, squares = 0.0;
        for (int i = 0; i < length; ++i) {
            const double value = (across ? image.data(i, line) : image.data(line, i))[0];
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
            for (int channel = 0; channel < 3; ++channel) {
                const int last = (across ? image->s() : image->t()) - 1;
                double largest = 0.0;
                for (int line = 0; line < last; ++line)
                    largest = std::max(largest, step(*image, across, line, channel));
                EXPECT_LE(step(*image, across, last, channel), largest)
                    << form << ", " << channel << (across ? " around" : " along");
            }
    }
}

TEST(BarkRelief, AllFormsHaveTheSameMeanBrightness) {
    for (int form = 0; form < forms; ++form) {
        const osg::ref_ptr<osg::Image> image = paintBark(static_cast<BarkForm>(form));
        double sum = 0.0;
        for (int i = 0; i < image->s() * image->t(); ++i)
            sum += image->data()[3 * i] / 255.0;
        EXPECT_NEAR(sum / (image->s() * image->t()), 0.75, 0.06) << form;
    }
}

TEST(BarkRelief, FurrowsRunAlongAndBandsAndRingsAcross) {
    const auto ratio = [](BarkForm form) {
        const osg::ref_ptr<osg::Image> image = paintBark(form);
        return variation(*image, true) / variation(*image, false);
    };
    EXPECT_GT(ratio(BarkForm::Furrowed), 1.02);
    EXPECT_LT(ratio(BarkForm::Banded), 0.95);
    EXPECT_LT(ratio(BarkForm::Ringed), 0.95);
}

TEST(BarkRelief, BeechesAreTheSmoothest) {
    const auto roughness = [](BarkForm form) { return variation(*paintBark(form), true); };
    for (int form = 0; form < forms; ++form)
        if (static_cast<BarkForm>(form) != BarkForm::Smooth) {
            EXPECT_GT(roughness(static_cast<BarkForm>(form)), roughness(BarkForm::Smooth)) << form;
        }
}
