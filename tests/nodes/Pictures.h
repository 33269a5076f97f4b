// SPDX-License-Identifier: MIT
#pragma once

#include <osg/Image>

#include <gtest/gtest.h>

#include <cstdlib>

/// The difference of two RGBA pictures of the same size.
struct Difference {
    double mean = 0.0;     ///< Mean absolute difference of colour values, 0 to 255.
    double outliers = 0.0; ///< Share of pixels with a difference above 32.
};

inline Difference difference(const osg::Image& a, const osg::Image& b) {
    Difference result;
    EXPECT_EQ(a.s() * a.t(), b.s() * b.t());
    const int pixels = a.s() * a.t();
    for (int i = 0; i < pixels; ++i) {
        int worst = 0;
        for (int c = 0; c < 3; ++c) {
            const int off = std::abs(int(a.data()[4 * i + c]) - int(b.data()[4 * i + c]));
            worst = std::max(worst, off);
            result.mean += off / (3.0 * pixels);
        }
        result.outliers += (worst > 32) / double(pixels);
    }
    return result;
}

/// Share of the pixels that are not black, the background of GlTest::render().
inline double covered(const osg::Image& image) {
    int pixels = 0;
    for (int i = 0; i < image.s() * image.t(); ++i)
        pixels += image.data()[4 * i] || image.data()[4 * i + 1] || image.data()[4 * i + 2];
    return pixels / double(image.s() * image.t());
}
