// SPDX-License-Identifier: MIT
#include <osgTreeWind/places/GridMapping.h>

#include <gtest/gtest.h>

#include <map>

namespace osgTreeWind {

namespace {

struct Known {
    const char *crs, *name;
    std::map<std::string, std::vector<double>> numbers;
};

/// Parameters from the EPSG registry.
const Known maps[] = {
    {"EPSG:25832",
     "transverse_mercator",
     {{"longitude_of_central_meridian", {9.0}},
      {"latitude_of_projection_origin", {0.0}},
      {"scale_factor_at_central_meridian", {0.9996}},
      {"false_easting", {500000.0}},
      {"false_northing", {0.0}},
      {"semi_major_axis", {6378137.0}},
      {"inverse_flattening", {298.257222101}},
      {"longitude_of_prime_meridian", {0.0}}}},
    {"EPSG:2154",
     "lambert_conformal_conic",
     {{"standard_parallel", {49.0, 44.0}},
      {"longitude_of_central_meridian", {3.0}},
      {"latitude_of_projection_origin", {46.5}},
      {"false_easting", {700000.0}},
      {"false_northing", {6600000.0}}}},
    {"EPSG:3035",
     "lambert_azimuthal_equal_area",
     {{"longitude_of_projection_origin", {10.0}},
      {"latitude_of_projection_origin", {52.0}},
      {"false_easting", {4321000.0}},
      {"false_northing", {3210000.0}}}},
};

} // namespace

TEST(GridMapping, HasTheCfAttributesOfAMap) {
    for (const Known& known : maps) {
        const GridMapping mapping = gridMappingOf(Crs::parse(known.crs).value()).value();
        EXPECT_EQ(mapping.name, known.name);
        const std::map<std::string, std::vector<double>> found(mapping.numbers.begin(),
                                                               mapping.numbers.end());
        for (const auto& [name, values] : known.numbers) {
            ASSERT_EQ(found.count(name), 1u) << known.crs << ' ' << name;
            ASSERT_EQ(found.at(name).size(), values.size()) << known.crs << ' ' << name;
            for (std::size_t i = 0; i < values.size(); ++i)
                EXPECT_NEAR(found.at(name)[i], values[i], 1e-9 * (1.0 + values[i]))
                    << known.crs << ' ' << name;
        }
        EXPECT_TRUE(Crs::parse(mapping.wkt).value().isSame(Crs::parse(known.crs).value()));
    }
}

TEST(GridMapping, UnsupportedProjectionHasOnlyWkt) {
    const GridMapping mapping = gridMappingOf(Crs::parse("EPSG:28992").value()).value();
    EXPECT_EQ(mapping.name, "");
    EXPECT_TRUE(mapping.numbers.empty());
    EXPECT_NE(mapping.wkt.find("Amersfoort"), std::string::npos);
}

} // namespace osgTreeWind
