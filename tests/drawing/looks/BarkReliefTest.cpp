// SPDX-License-Identifier: MIT
#include <osgTreeWind/drawing/looks/BarkRelief.h>

#include <gtest/gtest.h>

#include <cmath>

using namespace osgTreeWind;

namespace {

constexpr int forms = static_cast<int>(BarkForm::Ringed) + 1;

/// Mean difference between a row and the next one up, of a channel.
double step(const osg::Image& image, int row, int channel) {
    double sum = 0.0;
    for (int x = 0; x < image.s(); ++x)
        sum += std::abs(image.data(x, row)[channel] - image.data(x, (row + 1) % image.t())[channel]);
    return sum / image.s();
}

/// Standard deviation of the brightness along a row or up a column, in the mean of all.
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

TEST(BarkRelief, GoesOnWithoutASeam) {
    for (int form = 0; form < forms; ++form) {
        const osg::ref_ptr<osg::Image> image = paintBark(static_cast<BarkForm>(form));
        for (int channel = 0; channel < 3; ++channel) {
            double largest = 0.0;
            for (int row = 0; row + 1 < image->t(); ++row)
                largest = std::max(largest, step(*image, row, channel));
            EXPECT_LE(step(*image, image->t() - 1, channel), largest) << form << ", " << channel;
        }
    }
}

TEST(BarkRelief, IsAsBrightAsItsSpeciesSays) {
    for (int form = 0; form < forms; ++form) {
        const osg::ref_ptr<osg::Image> image = paintBark(static_cast<BarkForm>(form));
        double sum = 0.0;
        for (int i = 0; i < image->s() * image->t(); ++i)
            sum += image->data()[3 * i] / 255.0;
        EXPECT_NEAR(sum / (image->s() * image->t()), 0.75, 0.06) << form;
    }
}

TEST(BarkRelief, OaksAreFurrowedAlongAndBirchesAndPalmsBandedAcross) {
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
