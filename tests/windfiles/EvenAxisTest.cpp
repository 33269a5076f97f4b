// SPDX-License-Identifier: MIT
#include <osgTreeWind/windfiles/EvenAxis.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

using Indices = std::vector<std::size_t>;

/// The globe at whole degrees from Greenwich eastward.
constexpr EvenAxis longitudes{0.0, 1.0, 360, 360.0};

} // namespace

TEST(EvenAxis, WholeAxisIsAscending) {
    const AxisPart part = wholeAxis({50.0, -0.25, 3, 0.0});
    EXPECT_EQ(part.first, 49.5);
    EXPECT_EQ(part.step, 0.25);
    EXPECT_EQ(part.indices, (Indices{2, 1, 0}));
}

TEST(EvenAxis, PartHasOneMorePointOnEitherSide) {
    const AxisPart part = partAround({60.0, -1.0, 21, 0.0}, 47.2, 48.5);
    EXPECT_EQ(part.first, 46.0);
    EXPECT_EQ(part.indices, (Indices{14, 13, 12, 11, 10}));
}

TEST(EvenAxis, PartOutsideIsTheNearestEnd) {
    const AxisPart part = partAround({0.0, 10.0, 4, 0.0}, 100.0, 120.0);
    EXPECT_EQ(part.first, 10.0);
    EXPECT_EQ(part.indices, (Indices{1, 2, 3}));
}

TEST(EvenAxis, FindsNegativeLongitudesOnAnAxisFromZero) {
    const AxisPart part = partAround(longitudes, -116.5, -116.2);
    EXPECT_EQ(part.first, -118.0);
    EXPECT_EQ(part.indices, (Indices{242, 243, 244, 245}));
}

TEST(EvenAxis, PartContinuesAcrossTheSeam) {
    const AxisPart part = partAround(longitudes, -0.5, 0.5);
    EXPECT_EQ(part.first, -2.0);
    EXPECT_EQ(part.indices, (Indices{358, 359, 0, 1, 2}));
}

TEST(EvenAxis, WholeCircleHasEachPointOnce) {
    EXPECT_EQ(partAround(longitudes, -180.0, 180.0).indices.size(), 360u);
}

TEST(EvenAxis, FindsARegionShiftedByAPeriod) {
    const AxisPart part = partAround({350.0, 1.0, 21, 360.0}, -0.2, 0.2);
    EXPECT_EQ(part.first, -2.0);
    EXPECT_EQ(part.indices, (Indices{8, 9, 10, 11, 12}));
}

} // namespace osgTreeWind
