// SPDX-License-Identifier: MIT
// Damaged and inconsistent GRIB files: refused with a clear reason, without a crash.
#include <tests/MissingReader.h>
#include <tests/windfiles/GribReading.h>

namespace osgTreeWind {

namespace {

std::string messageOf(const grib::Field& field) {
    return grib::message(field);
}

grib::Field northwardOf(grib::Field field) {
    return grib::with(std::move(field), field.edition == 1 ? 34 : 3, northward);
}

grib::Field edition1() {
    grib::Field field;
    field.edition = 1;
    field.number = 33;
    field.type = 105;
    return field;
}

/// Offset of each section of a message.
std::vector<std::size_t> sectionsOf(const std::string& message, int edition) {
    const auto number = [&](std::size_t at, std::size_t count) {
        std::size_t value = 0;
        for (std::size_t i = 0; i < count; ++i)
            value = value << 8 | static_cast<unsigned char>(message[at + i]);
        return value;
    };
    std::vector<std::size_t> places = {0};
    for (std::size_t at = edition == 1 ? 8 : 16; at + 4 < message.size();
         at += number(at, edition == 1 ? 3 : 4))
        places.push_back(at);
    places.push_back(message.size() - 4);
    return places;
}

/// The problem of a file with these fields.
std::string problemOf(const std::vector<grib::Field>& fields) {
    std::string bytes;
    for (const grib::Field& field : fields)
        bytes += messageOf(field);
    return problemOfGrib(bytes);
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

} // namespace

TEST(GribDamage, RefusesTruncationInEverySection) {
    for (const int edition : {1, 2}) {
        grib::Field field = edition == 1 ? edition1() : grib::Field();
        const std::string u = messageOf(field), whole = u + messageOf(northwardOf(field));
        ASSERT_TRUE(readGribBytes(whole));
        for (const std::size_t section : sectionsOf(u, edition))
            for (const std::size_t more : {2u, 6u})
                if (const std::size_t length = section + more; length < u.size()) {
                    const std::string problem = problemOfGrib(whole.substr(0, u.size() + length));
                    const std::string place = "message 2, at byte " + std::to_string(u.size()) + ": ";
                    EXPECT_TRUE(has(problem, length < 4 ? "found only U" : place)) << length << problem;
                }
    }
}

TEST(GribDamage, RefusesInconsistentSections) {
    const std::string u = messageOf({}), v = messageOf(northwardOf({}));
    const std::vector<std::size_t> sections = sectionsOf(u, 2);
    for (std::size_t i = 1; i + 1 < sections.size(); ++i) {
        std::string bytes = u + v;
        bytes[sections[i] + 1] = '\x7f'; // its length
        EXPECT_TRUE(has(problemOfGrib(bytes), "is longer than the rest of the message")) << i;
        bytes = u + v;
        bytes[sections[i] + 4] = '\x09'; // its number
        EXPECT_TRUE(has(problemOfGrib(bytes), "expected a section 1 to 7, found 9")) << i;
    }
    std::string bytes = u + v;
    bytes[u.size() - 1] = '8';
    EXPECT_EQ(problemOfGrib(bytes),
              "message 1, at byte 0: expected its end after " + std::to_string(u.size()) + " bytes");
    bytes = u + v;
    bytes[sections[1] + 14] = 13; // its month
    EXPECT_EQ(problemOfGrib(bytes), "message 1, at byte 0: section 1 has a date that does not exist");
}

TEST(GribDamage, NamesMissingFields) {
    grib::Field u, high, later;
    high.level = 80.0;
    later.lead = 3;
    EXPECT_EQ(problemOf({u}), "expected fields of wind: U and V, or its speed and direction; found only U");
    EXPECT_EQ(problemOf({u, northwardOf(u), high}),
              "V at 80 m above ground at 2017-06-03T18:00:00Z is missing");
    EXPECT_EQ(problemOf({u, northwardOf(u), northwardOf(later)}),
              "U at 10 m above ground at 2017-06-03T21:00:00Z is missing");
    EXPECT_EQ(problemOf({u, u, northwardOf(u)}),
              "U at 10 m above ground at 2017-06-03T18:00:00Z occurs twice, as in an "
              "ensemble; expected one field for each");
    grib::Field temperature;
    temperature.category = 0;
    EXPECT_EQ(problemOf({temperature}),
              "expected fields of wind: U and V, or its speed and direction; found none");
    grib::Field surface;
    surface.type = 1;
    EXPECT_TRUE(has(problemOf({u, northwardOf(surface)}),
                    "U and V are at different kinds of levels: U at 10 m above ground"));
}

TEST(GribDamage, NamesLevelsWithoutHeights) {
    grib::Field low, high, height;
    low.type = high.type = height.type = 100;
    low.level = 100000;
    high.level = height.level = 90000;
    const std::vector<grib::Field> wind = {low, northwardOf(low), high, northwardOf(high)};
    EXPECT_EQ(problemOf(wind),
              "expected the geopotential heights of the 2 levels of wind at isobaric levels");
    height.category = 3;
    height.number = 5;
    std::vector<grib::Field> some = wind;
    some.push_back(height);
    EXPECT_EQ(problemOf(some), "geopotential height at 1000 hPa at 2017-06-03T18:00:00Z is missing");
    std::vector<grib::Field> other = wind;
    for (grib::Field field : wind) {
        field.type = 7; // tropopause
        other.push_back(field);
    }
    EXPECT_EQ(problemOf(other),
              "expected wind at heights above ground, or geopotential heights of its levels; "
              "found wind at isobaric levels, levels of other kinds");
}

TEST(GribDamage, RefusesDifferentGrids) {
    grib::Field u, moved, small, turned;
    moved.grid.longitude = 10.5;
    small.grid.rows = 2;
    u.grid.relativeToGrid = false;
    turned.grid.relativeToGrid = true;
    EXPECT_EQ(problemOf({u, northwardOf(moved)}),
              "U at 10 m above ground at 2017-06-03T18:00:00Z and V at 10 m above ground at "
              "2017-06-03T18:00:00Z lie on "
              "different grids, latitude and longitude of 4 x 3 and latitude and longitude of 4 x 3");
    EXPECT_TRUE(has(problemOf({u, northwardOf(small)}), "4 x 3 and latitude and longitude of 4 x 2"));
    EXPECT_TRUE(has(problemOf({u, northwardOf(turned)}),
                    "are relative to different norths: one to true north, one to the grid's north"));
}

TEST(GribDamage, RefusesUnevenGridsByName) {
    for (const auto& [number, problem] :
         {std::pair{1, "message 1, at byte 0: ecCodes cannot decode its grid, of template 1"}, // longer than
                                                                                               // template 0
          {40, "its grid is Gaussian, whose points are not evenly spaced"},
          {50, "its grid is spherical harmonics, whose points are not evenly spaced"},
          {101, "its grid is unstructured, whose points are not evenly spaced"},
          {999, "message 1, at byte 0: ecCodes cannot decode its grid, of template 999"}}) {
        std::string bytes;
        for (const std::string& message : {messageOf({}), messageOf(northwardOf({}))}) {
            bytes += message;
            const std::size_t grid = bytes.size() - message.size() + sectionsOf(message, 2)[2];
            bytes[grid + 12] = static_cast<char>(number >> 8);
            bytes[grid + 13] = static_cast<char>(number & 0xff);
        }
        EXPECT_TRUE(has(problemOfGrib(bytes), problem)) << number << problemOfGrib(bytes);
    }
}

TEST(GribDamage, RefusesHugeGridsBeforeAllocation) {
    std::string bytes;
    for (const std::string& message : {messageOf({}), messageOf(northwardOf({}))}) {
        bytes += message;
        const std::size_t grid = bytes.size() - message.size() + sectionsOf(message, 2)[2];
        bytes[grid + 30] = bytes[grid + 34] = '\x01'; // millions of columns and rows
    }
    EXPECT_TRUE(
        has(problemOfGrib(bytes),
            "expected at most 134217728 points, found latitude and longitude of 16777220 x 16777219"));
}

TEST(GribDamage, NamesUnknownPacking) {
    std::string bytes;
    for (const std::string& message : {messageOf({}), messageOf(northwardOf({}))}) {
        bytes += message;
        bytes[bytes.size() - message.size() + sectionsOf(message, 2)[4] + 10] =
            '\x77'; // template of section 5
    }
    const std::string problem = problemOfGrib(bytes);
    EXPECT_TRUE(has(problem, "U at 10 m above ground at 2017-06-03T18:00:00Z: ")) << problem;
    EXPECT_FALSE(has(problem, "/vsi")) << problem;
}

TEST(GribDamage, DecodesOnlyTheRequiredMessages) {
    const auto onGrid999 = [](std::string message) {
        message[sectionsOf(message, 2)[2] + 12] = '\3';
        message[sectionsOf(message, 2)[2] + 13] = '\xe7';
        return message;
    };
    const auto packedOtherwise = [](std::string message) {
        message[sectionsOf(message, 2)[4] + 9] = '\3';
        return message;
    };
    const auto secondOrder = [](std::string message) {
        message[sectionsOf(message, 1)[3] + 3] |= 0x40;
        return message;
    };
    const auto inMonth13 = [](std::string message) {
        message[sectionsOf(message, 2)[1] + 14] = 13;
        return message;
    };
    grib::Field temperature, temperature1 = edition1(), gusts, isobaric, height;
    temperature.category = 0;
    temperature1.number = 11;
    gusts.product = 8; // over a time span
    isobaric.type = height.type = 100;
    isobaric.level = height.level = 85000;
    height.category = 3;
    height.number = 5;
    const std::string wind = messageOf({}) + messageOf(northwardOf({}));
    for (const std::string& other :
         {onGrid999(messageOf(temperature)), packedOtherwise(messageOf(temperature)),
          secondOrder(messageOf(temperature1)), inMonth13(messageOf(temperature)),
          onGrid999(messageOf(gusts)), onGrid999(messageOf(isobaric)), packedOtherwise(messageOf(height))}) {
        EXPECT_EQ(problemOfGrib(wind + other), "");
        EXPECT_EQ(problemOfGrib(other + wind), "");
    }
    grib::Field high;
    high.level = 80.0;
    const std::string place = "message 3, at byte " + std::to_string(wind.size()) + ": ";
    EXPECT_EQ(problemOfGrib(wind + onGrid999(messageOf(high))),
              place + "ecCodes cannot decode its grid, of template 999");
    EXPECT_EQ(
        problemOfGrib(messageOf(isobaric) + messageOf(northwardOf(isobaric)) + onGrid999(messageOf(height))),
        "message 3, at byte " + std::to_string(wind.size()) +
            ": ecCodes cannot decode its grid, of template 999");
}

TEST(GribDamage, RefusesValuesThatContradictTheirSection) {
    std::string first, second;
    for (const std::string& message : {messageOf(edition1()), messageOf(northwardOf(edition1()))}) {
        first += message;
        first[first.size() - message.size() + sectionsOf(message, 1)[3] + 3] |= 0x40; // second-order packing
    }
    for (const std::string& message : {messageOf({}), messageOf(northwardOf({}))}) {
        second += message;
        second[second.size() - message.size() + sectionsOf(message, 2)[4] + 10] = 41; // PNG packing
    }
    EXPECT_EQ(problemOfGrib(first), "message 1, at byte 0: ecCodes cannot decode the packing of its values");
    EXPECT_TRUE(has(problemOfGrib(second),
                    "U at 10 m above ground at 2017-06-03T18:00:00Z: its values, packed "
                    "as grid_png, cannot be read: "))
        << problemOfGrib(second);
}

TEST(GribDamage, NamesTheMissingReaderProgram) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a", messageOf({}));
    expectMissingReaderError("OSGTREEWIND_WEATHER", path, "GRIB", "GDAL and ecCodes",
                             [&] { return firstProblem(readAt(path)); });
}

} // namespace osgTreeWind
