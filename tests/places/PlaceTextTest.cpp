// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/PlaceText.h>

#include <gtest/gtest.h>

namespace osgTreeWind {

namespace {

using Kind = PlaceText::Kind;

/// (longitude, latitude) of the tree in all texts: 9°58'51.6" E, 53°33'0.36" N
constexpr glm::dvec2 tree(9.981, 53.5501);

void expectTree(const char* text, bool isOrdered) {
    const PlaceText place = parsePlace(text);
    ASSERT_EQ(place.kind, Kind::Pair) << text;
    EXPECT_EQ(place.isOrdered, isOrdered) << text;
    EXPECT_NEAR(place.place.x, tree.x, 1e-9) << text;
    EXPECT_NEAR(place.place.y, tree.y, 1e-9) << text;
}

} // namespace

TEST(PlaceText, ReadsACoordinate) {
    for (const char* text : {"9.981", " 9,981 ", "+9.981", "9.981E", "E 9.981", "9.981° e", "9°58'51.6\"E",
                             "9° 58' 51.6\" E", "9 58 51.6 E", "9 58 51,6", "9:58:51.6", "9º58’51.6’’E",
                             "9°58′51.6″", "E9 58.86", "9°58.86'", "9d58'51.6\"E", "9 deg 58' 51.6\" E"}) {
        const auto coordinate = parseCoordinate(text);
        ASSERT_TRUE(coordinate) << text;
        EXPECT_NEAR(coordinate->value, 9.981, 1e-9) << text;
    }
    EXPECT_NEAR(parseCoordinate("-9 58 51.6")->value, -9.981, 1e-9);
    EXPECT_NEAR(parseCoordinate("9°58'51.6\"W")->value, -9.981, 1e-9);
    EXPECT_NEAR(parseCoordinate("S9°58'51.6\"")->value, -9.981, 1e-9);
    EXPECT_EQ(parseCoordinate("9 W")->axis, 'x');
    EXPECT_EQ(parseCoordinate("9 S")->axis, 'y');
    EXPECT_EQ(parseCoordinate("9")->axis, 0);
    EXPECT_FALSE(parseCoordinate("9.5")->isDegrees);
    EXPECT_TRUE(parseCoordinate("9 30")->isDegrees);
    EXPECT_TRUE(parseCoordinate("9.5°")->isDegrees);
}

TEST(PlaceText, RefusesOtherCoordinates) {
    for (const char* text : {"", "E", "oak", "9 61 0", "9 58 61", "9.5 30", "9 58.5 30", "9 58 51 6", "91 N",
                             "361 E", "-9 W", "9 O", "9'", "9°58\"", "E9W", "9e5", "9°58'51.6\"E x", "1.2.3"})
        EXPECT_FALSE(parseCoordinate(text)) << text;
}

TEST(PlaceText, ReadsTwoCoordinatesInOneCell) {
    for (const char* text :
         {"53°33'0.36\"N 9°58'51.6\"E", "N53°33'0.36\", E9°58'51.6\"", "9°58'51.6\"E, 53°33'0.36\"N",
          "53.5501N 9.981E", "053.5501N009.981E", "N53.5501 E9.981", "53 33 0.36 N 9 58 51.6 E",
          "53,5501 N; 9,981 E", "(53.5501 N, 9.981 E)"})
        expectTree(text, true);
    for (const char* text :
         {"9.981, 53.5501", "9.981,53.5501", "9.981 53.5501", "9.981;53.5501", "9,981; 53,5501",
          "9,981, 53,5501", "9,981 53,5501", "9.981 / 53.5501", "(9.981, 53.5501)", "[9.981, 53.5501]",
          "9 58 51.6, 53 33 0.36", "9 58 51.6 53 33 0.36", "9°58'51.6\" 53°33'0.36\"",
          "1 Union Street\nHamburg\n(9.981, 53.5501)"})
        expectTree(text, false);
    EXPECT_TRUE(parsePlace("(9.981, 53.5501)").hasBrackets);
    EXPECT_FALSE(parsePlace("9.981, 53.5501").hasBrackets);
}

TEST(PlaceText, ReadsPointsOfWkt) {
    for (const char* text : {"POINT (9.981 53.5501)", "POINT(9.981 53.5501)", "point  ( 9.981  53.5501 )",
                             "SRID=4326;POINT(9.981 53.5501)", "srid=4326; Point (9.981 53.5501)"}) {
        const PlaceText place = parsePlace(text);
        EXPECT_EQ(place.kind, Kind::Point) << text;
        EXPECT_EQ(place.place, tree) << text;
        EXPECT_FALSE(place.z) << text;
        EXPECT_EQ(place.srid, text[0] == 'S' || text[0] == 's' ? 4326 : 0) << text;
    }
    EXPECT_EQ(parsePlace("POINT Z (9.981 53.5501 12.5)").z, 12.5);
    EXPECT_EQ(parsePlace("POINTZ(9.981 53.5501 12.5)").z, 12.5);
}

TEST(PlaceText, LeavesOtherGeometriesToTheMapProgram) {
    for (const char* text :
         {"POLYGON ((0 0,1 0,1 1,0 0))", "MULTIPOINT ((1 2))", "POINT M (1 2 3)",
          R"({"type": "Point", "coordinates": [1, 2]})", "0101000000000000000000F03F0000000000000040",
          "\\x0101000000000000000000f03f0000000000000040"})
        EXPECT_EQ(parsePlace(text).kind, Kind::Geometry) << text;
    const PlaceText outline = parsePlace("SRID=25832;POLYGON ((0 0,1 0,1 1,0 0))");
    EXPECT_EQ(outline.srid, 25832);
    EXPECT_EQ(outline.geometry, "POLYGON ((0 0,1 0,1 1,0 0))");
}

TEST(PlaceText, RefusesOtherTexts) {
    for (const char* text : {"", "nowhere", "53.55", "53.55, 9.98, 3", "53.55N 9.98N", "SRID=;POINT(1 2)",
                             "SRID=x;POINT(1 2)", "SRID=4326", "1;2;3;4", "53°33'N, 9°58'O", "((1, 2))", "("})
        EXPECT_EQ(parsePlace(text).kind, Kind::None) << text;
}

} // namespace osgTreeWind
