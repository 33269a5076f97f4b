// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/CrsMesh.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

namespace osgTreeWind {

namespace {

CrsMesh meshOver(const std::string& from, const std::string& to, const glm::dvec2& low,
                 const glm::dvec2& high) {
    auto mesh = CrsMesh::makeLinear(Crs::parse(from).value(), Crs::parse(to).value(), low, high);
    EXPECT_TRUE(mesh) << mesh.problems().front().text();
    return mesh ? mesh.value() : CrsMesh();
}

/// Degrees clockwise from +y.
double bearing(const glm::dvec2& v) {
    return glm::degrees(std::atan2(v.x, v.y));
}

constexpr const char* lambert = "+proj=lcc +lat_1=25 +lat_2=25 +lat_0=25 +lon_0=-95 +R=6371229";

} // namespace

TEST(CrsMesh, IsWithinCentimetresOfProj) {
    const Crs utm = Crs::parse("EPSG:32611").value(), model = Crs::parse(lambert).value();
    const CrsMesh mesh = meshOver("EPSG:32611", lambert, {300000, 5050000}, {500000, 5150000});
    const CrsTransform transform = CrsTransform::between(utm, model).value();
    double largestError = 0.0;
    for (double x = 300000; x < 500000; x += 1717.0)
        for (double y = 5050000; y < 5150000; y += 1313.0) {
            glm::dvec2 exact(x, y);
            ASSERT_TRUE(transform.apply(exact));
            largestError = std::max(largestError, glm::distance(exact, mesh.transformed({x, y})));
        }
    EXPECT_LT(largestError, 0.05);
    EXPECT_GT(largestError, 0.0);
}

TEST(CrsMesh, CubicIsWithinAMicrometreOfProj) {
    for (const auto& [low, high] : {std::pair(glm::dvec2(300000, 5050000), glm::dvec2(500000, 5150000)),
                                    {glm::dvec2(450000, 5100000), glm::dvec2(450700, 5100200)}}) {
        const Crs utm = Crs::parse("EPSG:32611").value(), model = Crs::parse(lambert).value();
        const auto mesh = CrsMesh::makeCubic(utm, model, low, high);
        ASSERT_TRUE(mesh);
        const CrsTransform transform = CrsTransform::between(utm, model).value();
        std::vector<glm::dvec2> places;
        for (double x = 0.0; x <= 1.0; x += 0.017)
            for (double y = 0.0; y <= 1.0; y += 0.013)
                places.push_back(glm::mix(low, high, glm::dvec2(x, y)));
        std::vector<glm::dvec2> exact = places;
        transform.apply(exact);
        double largestError = 0.0;
        for (std::size_t i = 0; i < places.size(); ++i)
            largestError =
                std::max(largestError, glm::distance(exact[i], mesh.value().transformed(places[i])));
        EXPECT_LT(largestError, 1e-6);
        EXPECT_TRUE(mesh.value().covers(high));
        EXPECT_FALSE(mesh.value().covers(high + 2000.0));
    }
}

TEST(CrsMesh, NorthDiffersByTheMeridianConvergence) {
    const double convergence = glm::degrees(std::atan(
        std::tan(glm::radians(1.0)) * std::sin(glm::radians(46.0)))); // world.md: 0.719 at 116 W, 46 N
    EXPECT_NEAR(convergence, 0.719, 5e-4);
    glm::dvec2 place(-116.0, 46.0);
    const Crs degrees = Crs::wgs84(), utm = Crs::parse("EPSG:32611").value();
    ASSERT_TRUE(CrsTransform::between(degrees, utm).value().apply(place));
    const CrsMesh mesh = meshOver("EPSG:32611", "EPSG:4326", place - 20000.0, place + 20000.0);
    EXPECT_NEAR(bearing(mesh.north(place)), -convergence, 1e-3)
        << "east of 117 W, true north is west of grid north";
    EXPECT_NEAR(mesh.transformed(place).x, -116.0, 1e-6);
    EXPECT_NEAR(mesh.transformed(place).y, 46.0, 1e-6);
}

TEST(CrsMesh, ExtrapolatesBeyondItsArea) {
    const CrsMesh mesh = meshOver("EPSG:32611", "EPSG:4326", {500000, 5000000}, {510000, 5010000});
    EXPECT_NEAR(mesh.transformed({500000, 5020000}).y, 45.33, 0.01);
    EXPECT_NEAR(glm::length(mesh.north({1e9, -1e9})), 1.0, 1e-9);
}

TEST(CrsMesh, IsContinuousAcrossTheDateLine) {
    const CrsMesh mesh = meshOver("EPSG:32601", "EPSG:4326", {150000, 0}, {350000, 100000});
    EXPECT_LT(std::abs(mesh.transformed({150000, 0}).x - mesh.transformed({350000, 0}).x), 2.0);
}

TEST(CrsMesh, AcceptsAnAreaOfZeroSize) {
    const CrsMesh mesh = meshOver("EPSG:32611", "EPSG:4326", {500000, 5000000}, {500000, 5000000});
    EXPECT_NEAR(mesh.transformed({500000, 5000000}).x, -117.0, 1e-9);
}

TEST(CrsMesh, RejectsAnAreaOutsideTheTargetSystem) {
    const auto mesh = CrsMesh::makeLinear(Crs::parse("EPSG:32611").value(),
                                          Crs::parse("+proj=ortho +lat_0=-46 +lon_0=63").value(),
                                          {500000, 5000000}, {510000, 5010000});
    ASSERT_FALSE(mesh);
    EXPECT_NE(mesh.problems().front().text().find("are not on"), std::string::npos);
}

} // namespace osgTreeWind
