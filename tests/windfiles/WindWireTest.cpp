// SPDX-License-Identifier: MIT
#include <tests/base/FirstProblem.h>
#include <tests/base/WireFile.h>

#include <osgTreeWind/base/Wire.h>
#include <osgTreeWind/system/Descriptor.h>
#include <osgTreeWind/windfiles/WindContent.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

WindContent someGrid() {
    WindContent content;
    content.summary.format = "made";
    content.summary.start = "now";
    content.summary.notes = {"one", "", "three"};
    GridWind::Grid grid;
    grid.points = {2, 1, 1};
    grid.origin = {1.5, -2.5, 1e300};
    grid.times = {0.0, 7.0};
    grid.values = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
    content.data = grid;
    return content;
}

std::optional<Result<WindContent>> receiveFirst(WireFile& file, std::int64_t length) {
    file.truncate(length);
    file.rewind();
    return Wire::receive<WindContent>(file.descriptor());
}

} // namespace

TEST(WindWire, ReceivesWhatWasSent) {
    WireFile file;
    Result<WindContent> sent = someGrid();
    ASSERT_TRUE(Wire::send(file.descriptor(), sent));
    const auto received = receiveFirst(file, file.length());
    ASSERT_TRUE(received && *received);
    const WindContent& content = received->value();
    EXPECT_EQ(content.summary.format, "made");
    EXPECT_EQ(content.summary.start, "now");
    EXPECT_EQ(content.summary.notes, sent.value().summary.notes);
    const auto &grid = std::get<GridWind::Grid>(content.data),
               &made = std::get<GridWind::Grid>(sent.value().data);
    EXPECT_EQ(grid.points, made.points);
    EXPECT_EQ(grid.origin, made.origin);
    EXPECT_EQ(grid.times, made.times);
    EXPECT_EQ(grid.values, made.values);
}

TEST(WindWire, ReceivesProblems) {
    WireFile file;
    Result<WindContent> sent = Diagnostic{"a.nc", 0, 0, "u", "is wrong"};
    ASSERT_TRUE(Wire::send(file.descriptor(), sent));
    const auto received = receiveFirst(file, file.length());
    ASSERT_TRUE(received);
    EXPECT_EQ(firstProblem(*received), "a.nc: u: is wrong");
}

TEST(WindWire, ReceivesNothingFromATruncatedStream) {
    WireFile file;
    Result<WindContent> sent = someGrid();
    ASSERT_TRUE(Wire::send(file.descriptor(), sent));
    for (std::int64_t length = file.length() - 1; length >= 0; --length)
        EXPECT_FALSE(receiveFirst(file, length)) << length;
}

TEST(WindWire, AllocatesOnlyForReceivedNumbers) {
    WireFile file;
    const std::string claims = std::string(1, '\1') + std::string(8, '\x7f') + "and then little";
    ASSERT_EQ(writeSome(file.descriptor(), claims.data(), claims.size()),
              static_cast<std::ptrdiff_t>(claims.size()));
    EXPECT_FALSE(receiveFirst(file, static_cast<std::int64_t>(claims.size())));
}

} // namespace osgTreeWind
