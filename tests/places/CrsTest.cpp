// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsTransform.h>

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace osgTreeWind {

namespace {

Crs crsOf(const std::string& text) {
    const auto crs = Crs::parse(text);
    EXPECT_TRUE(crs) << crs.problems().front().text();
    return crs.value();
}

glm::dvec2 transformed(const glm::dvec2& place, const std::string& from, const std::string& to) {
    const auto transform = CrsTransform::between(crsOf(from), crsOf(to));
    EXPECT_TRUE(transform);
    glm::dvec2 result = place;
    EXPECT_TRUE(transform.value().apply(result)) << place.x << ' ' << place.y;
    return result;
}

std::string problemOfMap(const std::string& text) {
    const auto crs = Crs::parseMap(text);
    return crs ? "" : crs.problems().front().text();
}

} // namespace

TEST(Crs, AcceptsAnyFormThatProjAccepts) {
    const std::string wkt = crsOf("EPSG:25832").text();
    EXPECT_EQ(wkt, "EPSG:25832");
    EXPECT_EQ(crsOf("EPSG:25832").name(), "ETRS89 / UTM zone 32N");
    EXPECT_EQ(crsOf("http://www.opengis.net/def/crs/EPSG/0/7415").text(), "EPSG:28992")
        << "the vertical part is dropped";
    const std::string custom = crsOf("+proj=tmerc +lon_0=9.25 +k=1 +x_0=7 +ellps=GRS80").text();
    EXPECT_EQ(crsOf(custom).text(), custom) << "without a code, it is WKT";
}

TEST(Crs, SceneMustBeProjectedInMetres) {
    EXPECT_EQ(problemOfMap("EPSG:32633"), "");
    EXPECT_EQ(problemOfMap("EPSG:31467"), "") << "x is the easting despite its axis order north, east";
    EXPECT_EQ(problemOfMap("EPSG:4326"),
              "crs: expected a projected system in metres, found WGS 84, which uses degrees");
    EXPECT_EQ(problemOfMap("EPSG:2263"),
              "crs: expected a projected system in metres, found NAD83 / New York Long "
              "Island (ftUS) in US survey foot");
    EXPECT_NE(problemOfMap("EPSG:4978").find("expected a projected system in metres"), std::string::npos);
    EXPECT_NE(problemOfMap("EPSG:5513").find("x to the east"), std::string::npos) << "Krovak, south and west";
}

TEST(Crs, RejectsInvalidTextWithAMessageOfOneLine) {
    for (const std::string text :
         {"", "EPSG:1", "utm 32", "+proj=nothing", "PROJCS[\"half", "\x01\x02", "http://127.0.0.1:9/crs",
          "/vsicurl/http://127.0.0.1:9/crs", "/etc/passwd"}) {
        const auto crs = Crs::parse(text);
        ASSERT_FALSE(crs) << text;
        EXPECT_EQ(crs.problems().size(), 1u);
        EXPECT_EQ(crs.problems().front().text().find("crs: expected a coordinate reference system"), 0u)
            << crs.problems().front().text();
        EXPECT_EQ(crs.problems().front().text().find('\n'), std::string::npos);
    }
}

TEST(Crs, FindsUtmZonesAroundTheEarth) {
    const auto zone = [](double longitude, double latitude) {
        return Crs::utmOf({longitude, latitude}).value().text();
    };
    EXPECT_EQ(zone(9.0, 50.0), "EPSG:32632");
    EXPECT_EQ(zone(-120.74, 35.3), "EPSG:32610");
    EXPECT_EQ(zone(151.2, -33.9), "EPSG:32756");
    EXPECT_EQ(zone(-180.0, 1.0), "EPSG:32601");
    EXPECT_EQ(zone(180.0, 1.0), "EPSG:32601");
    EXPECT_EQ(zone(179.999, 1.0), "EPSG:32660");
}

/// A zone's central meridian has easting 500 km, and the equator northing 0.
TEST(CrsTransform, TransformsToTheMapAndBack) {
    const glm::dvec2 middle = transformed({9.0, 0.0}, "EPSG:4326", "EPSG:32632");
    EXPECT_NEAR(middle.x, 500000.0, 1e-6);
    EXPECT_NEAR(middle.y, 0.0, 1e-6);
    // Snyder, Map Projections (USGS 1395), p. 269: 73.5 W, 40.5 N on Clarke 1866, k 0.9996 from 75 W, 0 N.
    const glm::dvec2 snyder = transformed({-73.5, 40.5}, "+proj=longlat +ellps=clrk66",
                                          "+proj=tmerc +lon_0=-75 +k=0.9996 +ellps=clrk66");
    EXPECT_NEAR(snyder.x, 127106.5, 0.1);
    EXPECT_NEAR(snyder.y, 4484124.4, 0.1);
    const glm::dvec2 back =
        transformed(transformed({13.4, 52.5}, "EPSG:4326", "EPSG:25833"), "EPSG:25833", "EPSG:4326");
    EXPECT_NEAR(back.x, 13.4, 1e-9);
    EXPECT_NEAR(back.y, 52.5, 1e-9);
}

TEST(CrsTransform, BetweenEqualSystemsIsExact) {
    const glm::dvec2 place{428759.19, 4512931.77};
    EXPECT_EQ(transformed(place, "EPSG:26912", "EPSG:26912"), place);
}

TEST(CrsTransform, ReportsPlacesThatCannotBeTransformed) {
    const auto transform = CrsTransform::between(crsOf("EPSG:4326"), crsOf("EPSG:32632"));
    for (glm::dvec2 place : {glm::dvec2{9.0, 91.0}, glm::dvec2{NAN, 0.0}, glm::dvec2{9.0, INFINITY}})
        EXPECT_FALSE(transform.value().apply(place));
}

TEST(CrsTransform, ThreadsMayUseTheirOwnTransforms) {
    std::vector<std::thread> threads;
    for (int zone = 1; zone <= 8; ++zone)
        threads.emplace_back([zone] {
            const std::string utm = "EPSG:" + std::to_string(32600 + zone);
            for (int i = 0; i < 20; ++i)
                EXPECT_NEAR(transformed({6.0 * zone - 183.0, 10.0}, "EPSG:4326", utm).x, 500000.0, 1e-6);
        });
    for (std::thread& thread : threads)
        thread.join();
}

} // namespace osgTreeWind
